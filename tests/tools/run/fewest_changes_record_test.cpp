// SPDX-License-Identifier: Apache-2.0
// Which of the bodies with ever fewer changes MuJoCo passes.
#include "tools/run/fewest_changes_record.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(FewestChanges, TheLeastThatPassesHasTheFewestChangesWhateverFailsBetween) {
  FewestChangesRecord fewest;
  EXPECT_EQ(least_that_passes(fewest), nullptr);
  fewest.designs = {{{"a", "b", "c"}, 1.0, {}}, {{"a", "b"}, 2.0, {}}, {{"b"}, 3.0, {}}};
  EXPECT_EQ(least_that_passes(fewest), nullptr) << "nothing was played";
  for (FewerChangesRecord& design : fewest.designs) design.played = {1.0, false, "FAIL"};
  EXPECT_EQ(least_that_passes(fewest), nullptr);
  fewest.designs[0].played->pass = true;
  EXPECT_EQ(least_that_passes(fewest), &fewest.designs[0]);
  fewest.designs[2].played->pass = true;
  EXPECT_EQ(least_that_passes(fewest), &fewest.designs[2]);
}

}  // namespace
}  // namespace legwright
