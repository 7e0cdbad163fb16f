// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// The unit vector of "+x", "-x", "+y" or "-y"; nothing for another text.
std::optional<Eigen::Vector2d> facing_axis(std::string_view text);
/// "+x" for that vector.
std::string facing_text(const Eigen::Vector2d& axis);

/// What is so far ahead and to the left of a robot that looks along `forward`, in the frame of its
/// trunk.
Eigen::Vector2d from_facing(const Eigen::Vector2d& ahead_left, const Eigen::Vector2d& forward);
/// The inverse.
Eigen::Vector2d as_faced(const Eigen::Vector2d& in_trunk, const Eigen::Vector2d& forward);

/// footfall_order() of feet that stand around a robot which looks along `forward`.
std::vector<int> order_as_faced(std::vector<Eigen::Vector3d> feet, const Eigen::Vector2d& forward);

}  // namespace legwright
