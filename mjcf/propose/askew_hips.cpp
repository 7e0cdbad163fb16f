// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/askew_hips.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace legwright {
namespace {

using Eigen::Vector2d;

constexpr double kImage = 0.01;  // of what hips span: places that agree
constexpr double kAskewFrom =
    0.035;  // [rad] less is how a robot was measured, not how it was drawn
constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

/// Whether each hip has an image among them in the plane across `normal` at `distance`.
bool are_mirrored(const Eigen::Matrix2Xd& hips, const Vector2d& normal, double distance,
                  double tolerance) {
  for (Eigen::Index k = 0; k < hips.cols(); ++k) {
    const Vector2d image = hips.col(k) - 2.0 * (normal.dot(hips.col(k)) - distance) * normal;
    if ((hips.colwise() - image).colwise().norm().minCoeff() > tolerance) return false;
  }
  return true;
}

}  // namespace

std::optional<double> askew_hips(const Eigen::Matrix2Xd& hips) {
  if (hips.cols() < 4) return std::nullopt;
  const double span = (hips.rowwise().maxCoeff() - hips.rowwise().minCoeff()).maxCoeff();
  std::optional<double> least;
  for (Eigen::Index i = 0; i < hips.cols(); ++i)
    for (Eigen::Index j = i + 1; j < hips.cols(); ++j) {
      const Vector2d apart = hips.col(j) - hips.col(i);
      if (apart.norm() < 0.1 * span) continue;  // what says little of a direction
      const Vector2d normal = apart.normalized();
      const double distance = 0.5 * normal.dot(hips.col(i) + hips.col(j));
      if (!are_mirrored(hips, normal, distance, kImage * span)) continue;
      const double turn = std::remainder(std::atan2(normal.y(), normal.x()), kQuarterTurn);
      if (!least || std::abs(turn) < std::abs(*least)) least = turn;
    }
  return least && std::abs(*least) > kAskewFrom ? least : std::nullopt;
}

}  // namespace legwright
