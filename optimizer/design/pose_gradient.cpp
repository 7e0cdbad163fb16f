// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/pose_gradient.hpp"

#include <Eigen/Geometry>

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Adds μ · rate, entry by entry.
void add_rate(const Vector3d& rate, const Vector3d& multiplier, double& sum) {
  for (int k = 0; k < 3; ++k) sum += rate[k] * multiplier[k];
}

/// Calls visit(twist, its entry of the gradient) for all that moves a link.
template <class Visit>
void for_each_above(const Morphology& morphology, const PoseKinematics& pose, int link,
                    double* gradient, Visit visit) {
  for (; link > 0; link = morphology.links[link].parent)
    visit(pose.twist_of(5 + link), gradient[5 + link]);
  for (int c = 0; c < 6; ++c) visit(pose.twist_of(c), gradient[c]);
}

/// Σ a × b of what [turn]× X + shift sumᵀ sums up as Σ a bᵀ.
Vector3d swept_rate(const Vector3d& turn, const Matrix3d& X, const Vector3d& shift,
                    const Vector3d& sum) {
  const auto entry = [&](int row, int column) {
    const int next = (row + 1) % 3, last = (row + 2) % 3;
    return turn[next] * X(last, column) - turn[last] * X(next, column) + shift[row] * sum[column];
  };
  return {entry(1, 2) - entry(2, 1), entry(2, 0) - entry(0, 2), entry(0, 1) - entry(1, 0)};
}

}  // namespace

void add_point_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                        const Vector3d& point, const Vector3d& multiplier, double* gradient) {
  for_each_above(morphology, pose, link, gradient, [&](const Twist& twist, double& sum) {
    add_rate(twist.turn.cross(point) + twist.shift, multiplier, sum);
  });
}

void add_direction_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                            const Vector3d& direction, const Vector3d& multiplier,
                            double* gradient) {
  for_each_above(morphology, pose, link, gradient, [&](const Twist& twist, double& sum) {
    add_rate(twist.turn.cross(direction), multiplier, sum);
  });
}

void add_com_gradient(const GeometryAtDesign& geometry, const PoseKinematics& pose,
                      const Vector3d& multiplier, double* gradient) {
  const double scale = 1.0 / geometry.total_mass;
  const int count = 5 + static_cast<int>(geometry.links.size());
  for (int c = 0; c < count; ++c) {
    const Twist& twist = pose.twist_of(c);
    add_rate(scale * (twist.turn.cross(pose.first_moment(twist.link)) +
                      geometry.mass_below[static_cast<std::size_t>(twist.link)] * twist.shift),
             multiplier, gradient[c]);
  }
}

void add_swept_momentum_gradient(const PairMoments& moments, const PoseKinematics& first,
                                 const PoseKinematics& second, const Vector3d& multiplier,
                                 double* first_gradient, double* second_gradient) {
  const int count = 5 + moments.link_count();
  for (int c = 0; c < count; ++c) {
    const Twist& twist = first.twist_of(c);
    add_rate(swept_rate(twist.turn, moments.below(twist.link), twist.shift,
                        second.first_moment(twist.link)),
             multiplier, first_gradient[c]);
  }
  for (int c = 0; c < count; ++c) {
    const Twist& twist = second.twist_of(c);
    add_rate(-swept_rate(twist.turn, moments.below(twist.link).transpose(), twist.shift,
                         first.first_moment(twist.link)),
             multiplier, second_gradient[c]);
  }
}

void add_foot_turn_gradient(const Morphology& morphology, int foot, const PoseKinematics& first,
                            const PoseKinematics& second, const Vector3d& multiplier,
                            double* first_gradient, double* second_gradient) {
  const int link = morphology.feet[static_cast<std::size_t>(foot)].link;
  const Matrix3d swept = 0.5 * first.rotation(link) * second.rotation(link).transpose();
  const Matrix3d exchanged = swept.transpose();
  const Vector3d none = Vector3d::Zero();  // directions turn but do not shift
  for_each_above(morphology, first, link, first_gradient, [&](const Twist& twist, double& sum) {
    add_rate(swept_rate(twist.turn, swept, none, none), multiplier, sum);
  });
  for_each_above(morphology, second, link, second_gradient, [&](const Twist& twist, double& sum) {
    add_rate(-swept_rate(twist.turn, exchanged, none, none), multiplier, sum);
  });
}

}  // namespace legwright
