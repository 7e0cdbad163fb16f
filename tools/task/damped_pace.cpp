// SPDX-License-Identifier: Apache-2.0
#include "tools/task/damped_pace.hpp"

#include <algorithm>

#include "mjcf/propose/odd_joints.hpp"
#include "optimizer/motion/gait.hpp"
#include "optimizer/motion/margins.hpp"

namespace legwright {
namespace {

// Of a smooth move: its greatest speed over its mean one.
constexpr double kPeak = 1.57;
// Joints that fold a leg turn up to three times as fast as its foot moves for the leg's length: two
// fold against each other, and none stands square to the foot.
constexpr double kFolds = 3.0;
// Putting feet ahead may take this share of what lifting them may: joints do both at once.
constexpr double kStrideShare = 0.6;
constexpr double kLift = 0.1;  // of the leg: lower than usual, so that the cycle is shorter
// Numbers of a task are rounded to two digits, stances to knots.
constexpr double kRounded = 0.85;
// Of a cycle, two of whose knots feet are planted before and after stance.
constexpr double kPlanted = 2.0 / 24.0;

/// Share of a cycle in which a foot is in the air.
double airborne(double duty) { return std::max(0.1, 1.0 - duty - kPlanted); }

}  // namespace

void slow_down_for_damping(const RobotModel& robot, double duty, StarterTask& task) {
  const double fastest = damped_joint_speed(robot);
  if (!(fastest < kUsualJointSpeed)) return;
  const double foot = kRounded * fastest * robot.morphology.leg_length / kFolds;  // [m/s]
  if (!(foot > 0.0)) return;
  const double leg = standing_leg(robot.morphology, robot.space.initial());
  task.swing_height = std::min(task.swing_height.value_or(kLift * leg), kLift * leg);
  task.period = std::max(task.period, kPeak * 2.0 * *task.swing_height / (foot * airborne(duty)));
  task.speed = std::min(task.speed, kStrideShare * foot * airborne(duty) / (kPeak * duty));
  task.slowed = true;
}

double asked_joint_speed(const RobotModel& robot, const Task& task) {
  const int knots = task.gait.knot_count();
  const double height = task.swing_height.value_or(0.0);
  double asked = 0.0;
  for (int foot = 0; foot < task.gait.foot_count(); ++foot) {
    int standing = 0;
    for (int knot = 0; knot < knots; ++knot) standing += task.gait.in_contact(knot, foot);
    const double duty = static_cast<double>(standing) / knots;
    const double lift = 2.0 * height / task.gait.period();
    const double stride = duty * task.velocity.norm() / kStrideShare;
    asked = std::max(asked, kPeak * std::max(lift, stride) / airborne(duty));  // of the foot
  }
  return std::min(kFolds * asked / robot.morphology.leg_length, kUsualJointSpeed);
}

}  // namespace legwright
