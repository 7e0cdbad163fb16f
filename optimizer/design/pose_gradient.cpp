// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/pose_gradient.hpp"

#include "optimizer/design/small_products.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Adds μ · rate, entry by entry.
[[gnu::always_inline]] inline void add_rate(const Scalars3& rate, const Scalars3& multiplier,
                                            double& sum) {
  sum = sum + rate.x * multiplier.x + rate.y * multiplier.y + rate.z * multiplier.z;
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
template <class Matrix>
[[gnu::always_inline]] inline Scalars3 swept_rate(const Scalars3& t, const Matrix& X,
                                                  const Scalars3& v, const Scalars3& sum) {
  return {
      t.z * X(0, 2) - t.x * X(2, 2) + v.y * sum.z - (t.x * X(1, 1) - t.y * X(0, 1) + v.z * sum.y),
      t.x * X(1, 0) - t.y * X(0, 0) + v.z * sum.x - (t.y * X(2, 2) - t.z * X(1, 2) + v.x * sum.z),
      t.y * X(2, 1) - t.z * X(1, 1) + v.x * sum.y - (t.z * X(0, 0) - t.x * X(2, 0) + v.y * sum.x)};
}

}  // namespace

void add_point_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                        const Vector3d& point, const Vector3d& multiplier, double* gradient) {
  const Scalars3 at = scalars(point), mu = scalars(multiplier);
  for_each_above(morphology, pose, link, gradient, [&](const Twist& twist, double& sum) {
    add_rate(cross(scalars(twist.turn), at) + scalars(twist.shift), mu, sum);
  });
}

void add_trunk_point_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                              const Vector3d& at, const Vector3d& multiplier, double* gradient) {
  const Matrix3d& trunk = pose.rotation(0);
  const Vector3d point = pose.origin(0) + trunk * at;
  const Scalars3 p = scalars(point), mu = scalars(multiplier);
  for (; link > 0; link = morphology.links[static_cast<std::size_t>(link)].parent) {
    const Twist& twist = pose.twist_of(5 + link);
    const Scalars3 rate = cross(scalars(twist.turn), p) + scalars(twist.shift);
    add_rate(transposed_product(trunk, rate), mu, gradient[5 + link]);
  }
}

void add_direction_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                            const Vector3d& direction, const Vector3d& multiplier,
                            double* gradient) {
  const Scalars3 along = scalars(direction), mu = scalars(multiplier);
  for_each_above(morphology, pose, link, gradient, [&](const Twist& twist, double& sum) {
    add_rate(cross(scalars(twist.turn), along), mu, sum);
  });
}

void add_com_gradient(const GeometryAtDesign& geometry, const PoseKinematics& pose,
                      const Vector3d& multiplier, double* gradient) {
  const double scale = 1.0 / geometry.total_mass;
  const int count = 5 + static_cast<int>(geometry.links.size());
  const Scalars3 mu = scalars(multiplier);
  for (int c = 0; c < count; ++c) {
    const Twist& twist = pose.twist_of(c);
    const double mass = geometry.mass_below[static_cast<std::size_t>(twist.link)];
    add_rate(scale * (cross(scalars(twist.turn), scalars(pose.first_moment(twist.link))) +
                      mass * scalars(twist.shift)),
             mu, gradient[c]);
  }
}

void add_swept_momentum_gradient(const PairMoments& moments, const PoseKinematics& first,
                                 const PoseKinematics& second, const Vector3d& multiplier,
                                 double* first_gradient, double* second_gradient) {
  const int count = 5 + moments.link_count();
  const Scalars3 mu = scalars(multiplier);
  for (int c = 0; c < count; ++c) {
    const Twist& twist = first.twist_of(c);
    add_rate(swept_rate(scalars(twist.turn), moments.below(twist.link), scalars(twist.shift),
                        scalars(second.first_moment(twist.link))),
             mu, first_gradient[c]);
  }
  for (int c = 0; c < count; ++c) {
    const Twist& twist = second.twist_of(c);
    add_rate(-swept_rate(scalars(twist.turn), moments.below(twist.link).transpose(),
                         scalars(twist.shift), scalars(first.first_moment(twist.link))),
             mu, second_gradient[c]);
  }
}

void add_foot_turn_gradient(const Morphology& morphology, int foot, const PoseKinematics& first,
                            const PoseKinematics& second, const Vector3d& multiplier,
                            double* first_gradient, double* second_gradient) {
  const int link = morphology.feet[static_cast<std::size_t>(foot)].link;
  const Matrix3d half = 0.5 * first.rotation(link);
  Matrix3d swept;
  for (int k = 0; k < 3; ++k)
    store(product(half, scalars(second.rotation(link).row(k))), swept.col(k));
  const Scalars3 none{0.0, 0.0, 0.0}, mu = scalars(multiplier);  // directions turn but do not shift
  for_each_above(morphology, first, link, first_gradient, [&](const Twist& twist, double& sum) {
    add_rate(swept_rate(scalars(twist.turn), swept, none, none), mu, sum);
  });
  for_each_above(morphology, second, link, second_gradient, [&](const Twist& twist, double& sum) {
    add_rate(-swept_rate(scalars(twist.turn), swept.transpose(), none, none), mu, sum);
  });
}

}  // namespace legwright
