// SPDX-License-Identifier: Apache-2.0
#include "tools/run/fewest_changes_record.hpp"

namespace legwright {

void fields(Fields& f, FewerChangesRecord& design) {
  f("changed", design.changed, "parameters that are not those of the initial body");
  f("F", design.F, "weighted, J included");
  f("s", design.s);
  f("played", design.played, "what MuJoCo says of it within a few cycles");
}

void fields(Fields& f, FewestChangesRecord& fewest) {
  f("share", fewest.share, "of the fall of F that is to be kept");
  f("initial_F", fewest.initial_F);
  f("fewest", fewest.fewest, "index of the last of `designs` that keeps it");
  f("kept", fewest.kept, "whether the result is that design (optimize --few)");
  f("seconds", fewest.seconds);
  f("designs", fewest.designs, "from all changes to one");
}

const FewerChangesRecord* least_that_passes(const FewestChangesRecord& fewest) {
  const FewerChangesRecord* least = nullptr;
  for (const FewerChangesRecord& design : fewest.designs)
    if (design.played && design.played->pass &&
        (least == nullptr || design.changed.size() < least->changed.size()))
      least = &design;
  return least;
}

}  // namespace legwright
