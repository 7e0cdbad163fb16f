// SPDX-License-Identifier: Apache-2.0
// (16) between limbs and the trunk: what the home pose has costs nothing, what comes nearer does.
#include <gtest/gtest.h>

#include <algorithm>

#include "optimizer/objective/objective.hpp"
#include "tests/support/puppy.hpp"
#include "tests/support/standing.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

/// (16) alone, of limbs and the trunk, at a motion in which every hip is `bend` off its home.
double closeness_of_trunk(const test::Puppy& puppy, double bend, double width = 0.0) {
  Task task = test::make_sideways_task(false, 12);
  task.weights["limb_clearance"] = 1.0;
  task.limb_pairs.emplace();
  const Objective objective(puppy.morphology, puppy.space, task);
  VectorXd s = puppy.space.initial();
  s[puppy.space.size() - 2] += width;
  VectorXd m = test::standing_motion(objective, s);
  for (int i = 0; i < objective.layout().knot_count(); ++i)
    for (int a = 0; a < puppy.morphology.joint_count(); ++a)
      m[objective.layout().pose(i) + 6 + a - objective.layout().design_size()] =
          puppy.morphology.links[a + 1].joint.nominal + (a % 3 == 0 ? bend : 0.0);
  for (const TermValue& term : objective.terms(s, m))
    if (term.name == "limb_clearance") return term.value;
  ADD_FAILURE() << "no term limb_clearance";
  return 0.0;
}

TEST(TermMeaningOfTrunk, HomeCostsNothingAndWhatComesNearerDoes) {
  test::Puppy puppy = test::make_puppy(true);
  EXPECT_EQ(closeness_of_trunk(puppy, 0.8), 0.0);  // without capsules there is nothing to meet
  test::add_capsules(puppy);
  EXPECT_LT(closeness_of_trunk(puppy, 0.0), 1e-20);
  const double near = closeness_of_trunk(puppy, 0.4), nearer = closeness_of_trunk(puppy, 0.8);
  EXPECT_GT(near, 0.0);
  EXPECT_GT(nearer, near);
  puppy.morphology.capsule_pairs.clear();  // as after <exclude>
  EXPECT_EQ(closeness_of_trunk(puppy, 0.8), 0.0);
}

TEST(TermMeaningOfTrunk, ANarrowerBodyThanThatOfTheFileBringsLimbsNearer) {
  test::Puppy puppy = test::make_puppy(true);
  test::add_capsules(puppy, 0.045);
  EXPECT_LT(closeness_of_trunk(puppy, 0.0), 1e-20);
  EXPECT_GT(closeness_of_trunk(puppy, 0.0, -0.04), 0.0);
}

TEST(TermMeaningOfTrunk, WhatTouchesAtHomeIsLeftAlone) {
  for (const double radius : {0.02, 0.06}) {
    test::Puppy puppy = test::make_puppy(true);
    test::add_capsules(puppy, 0.035, radius);
    auto& pairs = puppy.morphology.capsule_pairs;  // of the thighs alone
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                               [](const auto& pair) { return pair.limb % 2 == 1; }),
                pairs.end());
    EXPECT_LT(closeness_of_trunk(puppy, 0.0), 1e-20);
    if (radius < 0.05)
      EXPECT_GT(closeness_of_trunk(puppy, 0.8), 1.0);
    else
      EXPECT_EQ(closeness_of_trunk(puppy, 0.8), 0.0);
  }
}

/// Capsules that hide some of their shapes: no distance is known better than that, so what is so
/// near at home costs.
TEST(TermMeaningOfTrunk, WhatCapsulesHideIsAddedAndWantsRoom) {
  const auto closeness = [](double hidden, double bend) {
    test::Puppy puppy = test::make_puppy(true);
    test::add_capsules(puppy, 0.045);
    for (CapsulePair& pair : puppy.morphology.capsule_pairs) pair.hidden = hidden;
    return closeness_of_trunk(puppy, bend);
  };
  EXPECT_LT(closeness(0.0, 0.0), 1e-20);
  EXPECT_GT(closeness(0.0002, 0.0), closeness(0.0, 0.0) + 1e-3);
  EXPECT_GT(closeness(0.0002, 0.2), closeness(0.0, 0.2));
  EXPECT_EQ(closeness(0.5, 0.8), 0.0);  // shapes that touch at home
}

}  // namespace
}  // namespace legwright
