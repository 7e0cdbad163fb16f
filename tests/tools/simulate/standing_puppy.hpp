// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/motion/gait.hpp"
#include "optimizer/motion/layout.hpp"

namespace legwright {

/// The example puppy with a plan in which it stands on all feet, or bounces on them: simple enough
/// to know what physics must say to it.
struct StandingPuppy {
  /// @param bounce amplitude of the trunk's height, joints fixed [m]: the feet leave the ground
  /// with it, and the planned forces are those that the accelerations need.
  explicit StandingPuppy(double bounce = 0.0);

  RobotModel robot;
  Gait gait;
  Layout layout;
  Eigen::VectorXd m;
  double weight = 0.0;  // [N]
};

}  // namespace legwright
