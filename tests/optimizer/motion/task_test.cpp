// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/task.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/puppy.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(Slope, UpLeansUphill) {
  const Vector3d ahead = up_on_slope({0.1, 0.0}, 0.2, 0.0);
  EXPECT_NEAR(ahead.x(), std::sin(0.2), 1e-15);  // against gravity one gets uphill
  EXPECT_NEAR(ahead.z(), std::cos(0.2), 1e-15);
  const Vector3d aside = up_on_slope({0.0, 0.1}, 0.2, 0.0);  // sideways: the way is to the left
  EXPECT_NEAR(aside.y(), std::sin(0.2), 1e-15);
  EXPECT_NEAR(aside.x(), 0.0, 1e-15);
  EXPECT_GT(up_on_slope({0.1, 0.0}, 0.0, 0.2).y(), 0.19);  // across: to the left of the way
  EXPECT_LT(up_on_slope({0.0, 0.1}, 0.0, 0.2).x(), -0.19);
  EXPECT_GT(up_on_slope({0.0, 0.0}, 0.2, 0.0).x(), 0.19);  // no way: forward
}

TEST(Slope, LevelGroundIsExactlyLevel) {
  EXPECT_EQ(up_on_slope({0.1, 0.2}, 0.0, 0.0), Vector3d::UnitZ());
}

TEST(Slope, AnglesComeBack) {
  for (const Vector2d& way : {Vector2d(0.1, 0.0), Vector2d(-0.2, 0.3), Vector2d(0.0, 0.0)}) {
    const SlopeAngles slope = slope_of(way, up_on_slope(way, 0.31, -0.17));
    EXPECT_NEAR(slope.along, 0.31, 1e-14);
    EXPECT_NEAR(slope.across, -0.17, 1e-14);
  }
}

TEST(RobotInTask, CarriesItsPayloadOnTheTrunk) {
  const test::Puppy puppy = test::make_puppy(true);
  Task task;
  EXPECT_EQ(as_in_task(puppy.morphology, task).total_mass(), puppy.morphology.total_mass());
  task.payload = Payload{0.5, {0.0, 0.0, 0.06}, {0.1, 0.1, 0.05}};
  const Morphology laden = as_in_task(puppy.morphology, task);
  EXPECT_NEAR(laden.total_mass(), puppy.morphology.total_mass() + 0.5, 1e-12);
  for (std::size_t l = 1; l < laden.links.size(); ++l)
    EXPECT_EQ(laden.links[l].masses.size(), puppy.morphology.links[l].masses.size());
}

TEST(RobotInTask, HasMotorsNoStrongerThanTheTaskAllows) {
  test::Puppy puppy = test::make_puppy(true);
  test::add_pistons(puppy);
  for (Link& link : puppy.morphology.links) link.joint.torque_limit = 3.0;
  puppy.morphology.links[1].joint.torque_limit = 0.5;
  Task task;
  task.torque_limit = 1.2;
  const Morphology weaker = as_in_task(puppy.morphology, task);
  EXPECT_EQ(weaker.links[1].joint.torque_limit, 0.5);  // it is weaker as it is
  for (int a = 1; a < weaker.joint_count(); ++a) {
    bool linear = false;
    for (const LinearActuator& piston : weaker.linear_actuators) linear |= piston.joint == a;
    EXPECT_EQ(weaker.links[a + 1].joint.torque_limit, linear ? 3.0 : 1.2) << a;
  }
  for (std::size_t k = 0; k < weaker.linear_actuators.size(); ++k)  // newtons are no newton metres
    EXPECT_EQ(weaker.linear_actuators[k].force_limit,
              puppy.morphology.linear_actuators[k].force_limit);
}

}  // namespace
}  // namespace legwright
