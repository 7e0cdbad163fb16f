// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/layout.hpp"

#include <gtest/gtest.h>

#include <set>

#include "optimizer/motion/path.hpp"
#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

TEST(Layout, EverySlotIsUsedOnce) {
  const test::Puppy puppy = test::make_puppy(true);
  const Task task = test::make_sideways_task(false, 24);
  const Layout layout(puppy.morphology, puppy.space.size(), task.gait, 1);
  std::multiset<int> used;
  const auto use = [&used](int first, int count) {
    for (int k = 0; k < count; ++k) used.insert(first + k);
  };
  use(0, layout.design_size());
  for (int i = 0; i <= layout.knot_count(); ++i) {
    use(layout.pose(i), layout.pose_size());
    use(layout.com(i), 3);
    use(layout.com_from_pose(i), 3);
    use(layout.swept_momentum(i), 3);
    for (int a = 0; a < layout.joint_count(); ++a) {
      if (i == layout.knot_count()) continue;
      use(layout.link_anchor(i, a + 1), 3);
      use(layout.joint_torque(i, a), 1);
    }
    for (int j = 0; j < layout.foot_count(); ++j) {
      use(layout.foot(i, j), 3);
      use(layout.foot_from_pose(i, j), 3);
      use(layout.foot_turn(i, j), 3);
      if (i < layout.knot_count()) use(layout.limb_end(i, j), 3);
      for (int which = 0; which < 2; ++which) use(layout.sole_direction(i, j, which), 3);
      EXPECT_EQ(layout.force(i, j) >= 0, task.gait.in_contact(i, j));
      if (layout.force(i, j) >= 0) use(layout.force(i, j), 3);
    }
  }
  use(layout.mass_share(), 1);
  use(layout.printed_volume(), 1);
  use(layout.home_inertia(), 6);
  ASSERT_EQ(static_cast<int>(used.size()), layout.extended_size());
  int expected = 0;
  for (int slot : used) EXPECT_EQ(slot, expected++);
  EXPECT_GE(layout.motion_size(), 614);
}

TEST(Layout, UnitsFollowTheQuantities) {
  const test::Puppy puppy = test::make_puppy(true);
  const Task task = test::make_sideways_task(true, 12);
  const Layout layout(puppy.morphology, puppy.space.size(), task.gait, 1);
  const Eigen::VectorXd units = layout.motion_units(0.2, 23.0);
  const auto unit = [&](int slot) { return units[slot - layout.design_size()]; };
  EXPECT_EQ(unit(layout.pose(3)), 0.2);
  EXPECT_EQ(unit(layout.pose(3) + 3), 1.0);
  EXPECT_EQ(unit(layout.pose(3) + 6), 1.0);
  EXPECT_EQ(unit(layout.foot(3, 2)), 0.2);
  EXPECT_EQ(unit(layout.force(0, 0)), 23.0);
}

TEST(WantedPath, OneCycleIsTheRigidMotionOfThePlane) {
  const WantedPath path({0.2, 0.1}, 0.5, 0.8);
  const Eigen::Vector3d later = path.position(0.8 + 0.3);
  EXPECT_LT((later - (path.turn() * path.position(0.3) + path.travel())).norm(), 1e-14);
  const WantedPath straight({0.2, 0.1}, 0.0, 0.8);
  EXPECT_LT((straight.travel() - Eigen::Vector3d(0.16, 0.08, 0)).norm(), 1e-15);
  const WantedPath nearly({0.2, 0.1}, 1e-7, 0.8);
  EXPECT_LT((nearly.travel() - straight.travel()).norm(), 1e-7);
}

}  // namespace
}  // namespace legwright
