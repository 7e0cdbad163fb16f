// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// Which way a robot seems to be drawn. Tasks take +x of the trunk's frame for ahead, unless told.
struct Facing {
  Eigen::Vector2d ahead = Eigen::Vector2d::UnitX();  // one of ±x, ±y of the trunk's frame
  std::string remark;  // where that is not +x: how that is known, and what to do; else empty
};

/// By the legs that their names call front and hind, where these stand apart along one axis;
/// without such names, of six legs and more, by the longer side of what hips span; else by where a
/// camera on the trunk looks out (eye_of()). Of four legs that stand farther apart along y a remark
/// asks.
Facing facing_of(const RobotModel& robot);

}  // namespace legwright
