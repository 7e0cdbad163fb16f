// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/path.hpp"

#include <cmath>
#include <limits>

namespace legwright {

WantedPath::WantedPath(const Eigen::Vector2d& velocity, double turn_rate, double period)
    : velocity_(velocity), turn_rate_(turn_rate), turn_angle_(turn_rate * period) {
  travel_ = position(period);
  turn_ = yaw_rotation(turn_angle_);
}

Eigen::Matrix3d WantedPath::yaw_rotation(double angle) {
  Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
  r(0, 0) = r(1, 1) = std::cos(angle);
  r(1, 0) = std::sin(angle);
  r(0, 1) = -r(1, 0);
  return r;
}

Eigen::Vector3d WantedPath::position(double time) const {
  // ∫ R(ω t) v dt = (sin ωt/ω, (1 − cos ωt)/ω) applied to v; straight on where ω is nearly zero.
  const double angle = turn_rate_ * time;
  const bool straight = std::abs(angle) < 1e-6;
  const double along = straight ? time : std::sin(angle) / turn_rate_;
  const double across = straight ? 0.5 * angle * time : (1.0 - std::cos(angle)) / turn_rate_;
  return {along * velocity_.x() - across * velocity_.y(),
          across * velocity_.x() + along * velocity_.y(), 0.0};
}

Eigen::Vector2d WantedPath::velocity_along_arc(const Eigen::Vector2d& step, double angle,
                                               double time) {
  const bool straight = std::abs(angle) < 1e-6;
  const double along = straight ? 1.0 : std::sin(angle) / angle;
  const double across = straight ? 0.5 * angle : (1.0 - std::cos(angle)) / angle;
  const double squared = along * along + across * across;  // of sin(angle/2)/(angle/2)
  if (squared < 1e-12) return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  return Eigen::Vector2d(along * step.x() + across * step.y(),
                         along * step.y() - across * step.x()) /
         (squared * time);
}

}  // namespace legwright
