// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// A camera with which a robot looks out.
struct Eye {
  std::string camera;                                // its name; may be empty
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();  // nearest of ±x, ±y of the trunk's frame
};

/// The first of the cameras that are fixed to the trunk and look away from its middle, nearly
/// level. Nothing where there is none, or where several look along different axes. Cameras that
/// look at the robot from outside are none.
std::optional<Eye> eye_of(const RobotModel& robot);

}  // namespace legwright
