// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// The robot's file with design s in it: only bound attributes and the declared values change, all
/// other bytes stay. Numbers are written with 12 significant digits, the values of the design as
/// well: the file is the robot at the design that it tells, which is `s` but for that rounding. The
/// initial design gives the file back byte for byte. Mesh assets may get copies beside them
/// (mesh_scales.hpp). The result is compiled and compared with the intended design to 1e-9; a
/// difference throws std::logic_error (a fault of ours).
/// @param s as long as the design, finite and within its bounds, else std::invalid_argument.
std::string rewrite_robot(const RobotModel& robot, const Eigen::VectorXd& s);

/// As rewrite_robot(), and quicker, for what is looked at and not kept, such as a body under
/// somebody's hand: keyframes stay as they are and nothing is compared.
std::string rewrite_body(const RobotModel& robot, const Eigen::VectorXd& s);

}  // namespace legwright
