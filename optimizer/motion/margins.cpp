// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/margins.hpp"

#include <algorithm>
#include <cmath>

#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/home_stance.hpp"

namespace legwright {
namespace {

// Found on robots with legs of 20 cm: 25 mm, 20 mm, 35 ms, 4e-3 s².
constexpr double kSwingShare = 0.12, kClearanceShare = 0.095, kTouchdownShare = 0.24;
constexpr double kKnownTimeSquared = 4e-3;

// Ratio of leg and height of the COM: 1.3 to 1.7 for robots that stand upright or on bent knees, 2
// where they crouch.
constexpr double kCrouch = 1.75;

}  // namespace

double standing_leg(const Morphology& morphology, const Eigen::VectorXd& s) {
  const double height = home_stance(morphology, s).com_height;
  return height > 0.0 ? std::min(morphology.leg_length, kCrouch * height) : morphology.leg_length;
}

double shortest_swing(const Gait& gait) {
  int fewest = gait.knot_count();
  for (int foot = 0; foot < gait.foot_count(); ++foot) {
    int airborne = 0;
    for (int knot = 0; knot < gait.knot_count(); ++knot) airborne += !gait.in_contact(knot, foot);
    fewest = std::min(fewest, airborne);
  }
  return (fewest + 1) * gait.time_step();  // from the last knot of a stance to the next one's first
}

double swing_height(const Task& task, double leg_length) {
  const double time = shortest_swing(task.gait);
  const double lift = std::min(kSwingShare * leg_length, kSwingLift * kGravity * time * time);
  return task.swing_height.value_or(std::max(lift, kSwingOver * task.step_over));
}

double limb_clearance(const Task& task, double leg_length) {
  return task.clearance.value_or(kClearanceShare * leg_length);
}

double touchdown_error(double leg_length) {
  return kTouchdownShare * std::sqrt(leg_length / kGravity);
}

double smoothness_time_squared(double leg_length) {
  return kKnownTimeSquared * (leg_length / kKnownLeg);
}

}  // namespace legwright
