// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// Which way a robot seems to be drawn. Tasks take +x of the trunk's frame for ahead, unless told.
struct Facing {
  Eigen::Vector2d ahead = Eigen::Vector2d::UnitX();  // one of ±x, ±y of the trunk's frame
  std::string known;                                 // where that is not +x: by what; else empty
  std::string remark;                                // the same, and what to do
};

/// Where somebody says that a robot faces; nothing: as facing_of() finds.
using Forward = std::optional<Eigen::Vector2d>;

/// By the legs that their names call front and hind, where these stand apart along one axis;
/// without such names by those that are called left and right; without these, of six legs and more,
/// by the longer side of what hips span; else by where a camera on the trunk looks out (eye_of()).
/// Two legs stand beside each other; more that hang below their hips swing ahead. Of four legs that
/// stand farther apart along y a remark asks.
Facing facing_of(const RobotModel& robot);

}  // namespace legwright
