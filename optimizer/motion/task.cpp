// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/task.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {

namespace {

Eigen::Vector2d direction(const Eigen::Vector2d& way) {
  return way.norm() > 1e-9 ? way.normalized() : Eigen::Vector2d::UnitX();
}
Eigen::Vector2d left_of(const Eigen::Vector2d& ahead) { return {-ahead.y(), ahead.x()}; }

}  // namespace

Eigen::Vector3d up_on_slope(const Eigen::Vector2d& way, double along, double across) {
  const Eigen::Vector2d ahead = direction(way), left = left_of(ahead);
  const Eigen::Vector2d level = std::tan(along) * ahead + std::tan(across) * left;
  return Eigen::Vector3d(level.x(), level.y(), 1.0).normalized();
}

SlopeAngles slope_of(const Eigen::Vector2d& way, const Eigen::Vector3d& up) {
  const Eigen::Vector2d ahead = direction(way), level = up.head<2>() / up.z();
  return {std::atan(level.dot(ahead)), std::atan(level.dot(left_of(ahead)))};
}

Morphology as_in_task(const Morphology& morphology, const Task& task) {
  Morphology out = morphology;
  if (task.payload)
    for (PointMass& point : point_masses(*task.payload))
      out.links.front().masses.push_back(std::move(point));
  if (!task.torque_limit) return out;
  for (int a = 0; a < out.joint_count(); ++a) {
    const bool linear = std::any_of(out.linear_actuators.begin(), out.linear_actuators.end(),
                                    [a](const LinearActuator& one) { return one.joint == a; });
    double& limit = out.links[a + 1].joint.torque_limit;
    if (!linear) limit = std::min(limit, *task.torque_limit);
  }
  return out;
}

}  // namespace legwright
