// SPDX-License-Identifier: Apache-2.0
#include "mjcf/scene/seen_shapes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>

#include "mjcf/read/feet.hpp"

namespace legwright {

std::vector<int> drawn_groups(const mjModel& model) {
  std::array<std::array<bool, 2>, kHighestSeenGroup + 1> has{};  // by group and whether it collides
  const auto is_seen = [&](int g) {
    return model.body_weldid[model.geom_bodyid[g]] != 0 && model.geom_group[g] >= 0 &&
           model.geom_group[g] <= kHighestSeenGroup;
  };
  const auto group = [&](int g) -> auto& {
    return has[static_cast<std::size_t>(model.geom_group[g])];
  };
  for (int g = 0; g < model.ngeom; ++g)
    if (is_seen(g)) group(g)[collides(model, g) ? 1 : 0] = true;
  std::set<int> with_pictures;  // bodies
  for (int g = 0; g < model.ngeom; ++g)
    if (is_seen(g) && !group(g)[1]) with_pictures.insert(model.geom_bodyid[g]);
  std::vector<int> out(model.geom_group, model.geom_group + model.ngeom);
  for (int g = 0; g < model.ngeom; ++g)
    if (is_seen(g) && !group(g)[0] && with_pictures.contains(model.geom_bodyid[g]))
      out[static_cast<std::size_t>(g)] = kHighestSeenGroup + 1;
  return out;
}

void hide_collision_shapes(mjModel& model) {
  const std::vector<int> groups = drawn_groups(model);
  std::copy(groups.begin(), groups.end(), model.geom_group);
}

}  // namespace legwright
