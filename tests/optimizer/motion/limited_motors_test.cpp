// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/limited_motors.hpp"

#include <gtest/gtest.h>

#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

TEST(LimitedMotors, HaveTheirLimitLessDryFrictionAtEachKnot) {
  test::Puppy puppy = test::make_puppy(true);
  for (Link& link : puppy.morphology.links) link.joint.torque_limit = INFINITY;
  Joint &free = puppy.morphology.links[2].joint, &rubbing = puppy.morphology.links[3].joint,
        &stuck = puppy.morphology.links[5].joint;
  free.torque_limit = rubbing.torque_limit = stuck.torque_limit = 2.0;
  rubbing.friction_loss = 0.5;
  stuck.friction_loss = 3.0;
  const Task task = test::make_sideways_task(true, 8);
  const Layout layout(puppy.morphology, puppy.space.size(), task.gait, 1);
  const std::vector<LimitedMotor> motors = limited_motors(puppy.morphology, layout);
  ASSERT_EQ(motors.size(), 24u);
  for (int i = 0; i < 8; ++i) {
    const LimitedMotor* const at = &motors[static_cast<std::size_t>(3 * i)];
    EXPECT_EQ(at[0].limit, 2.0);
    EXPECT_EQ(at[1].limit, 1.5);
    EXPECT_EQ(at[2].limit, 0.2) << "a tenth stays";
    EXPECT_EQ(at[1].knot, i);
    EXPECT_EQ(at[1].slot, layout.joint_torque(i, 2));
    EXPECT_EQ(at[1].name, rubbing.name);
  }
}

}  // namespace
}  // namespace legwright
