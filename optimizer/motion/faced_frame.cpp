// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/faced_frame.hpp"

#include "optimizer/motion/gait.hpp"

namespace legwright {

using Eigen::Vector2d;

std::optional<Vector2d> facing_axis(std::string_view text) {
  if (text.size() != 2 || (text[0] != '+' && text[0] != '-')) return std::nullopt;
  const double sign = text[0] == '+' ? 1.0 : -1.0;
  if (text[1] == 'x') return Vector2d(sign, 0.0);
  if (text[1] == 'y') return Vector2d(0.0, sign);
  return std::nullopt;
}

std::string facing_text(const Vector2d& axis) {
  return std::string(axis.sum() > 0.0 ? "+" : "-") + (axis.x() != 0.0 ? "x" : "y");
}

// Zeros stay without a sign, so that a robot that looks along +x has the numbers that it was given.
Vector2d from_facing(const Vector2d& ahead_left, const Vector2d& forward) {
  if (forward == Vector2d::UnitX()) return ahead_left;
  return ahead_left.x() * forward + ahead_left.y() * Vector2d(-forward.y(), forward.x()) +
         Vector2d::Zero();
}

Vector2d as_faced(const Vector2d& in_trunk, const Vector2d& forward) {
  return from_facing(in_trunk, {forward.x(), -forward.y()});
}

std::vector<int> order_as_faced(std::vector<Eigen::Vector3d> feet, const Vector2d& forward) {
  for (Eigen::Vector3d& foot : feet) foot.head<2>() = as_faced(foot.head<2>(), forward);
  return footfall_order(feet);
}

}  // namespace legwright
