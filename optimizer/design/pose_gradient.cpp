// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/pose_gradient.hpp"

#include <algorithm>

#include "optimizer/design/small_products.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Takes the rate ∂y/∂c of one coordinate c of a pose after the other: adds μ · rate to a gradient,
/// entry by entry.
struct GradientOf {
  Scalars3 multiplier;
  double* gradient;

  [[gnu::always_inline]] void operator()(int coordinate, const Scalars3& rate) const {
    double& sum = gradient[coordinate];
    sum = sum + rate.x * multiplier.x + rate.y * multiplier.y + rate.z * multiplier.z;
  }
};

/// The same, into a Jacobian of columns × 3.
struct JacobianOf {
  const Columns& columns;
  Eigen::MatrixXd& jacobian;

  [[gnu::always_inline]] void operator()(int coordinate, const Scalars3& rate) const {
    double* out = jacobian.data() + columns[static_cast<std::size_t>(coordinate)];
    const Eigen::Index rows = jacobian.rows();
    out[0] += rate.x;
    out[rows] += rate.y;
    out[2 * rows] += rate.z;
  }
};

/// Calls visit(coordinate, its twist) for all that moves a link.
template <class Visit>
void for_each_above(const Morphology& morphology, const PoseKinematics& pose, int link,
                    Visit visit) {
  for (; link > 0; link = morphology.links[static_cast<std::size_t>(link)].parent)
    visit(5 + link, pose.twist_of(5 + link));
  for (int c = 0; c < 6; ++c) visit(c, pose.twist_of(c));
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

template <class Take>
void point_rates(const Morphology& morphology, const PoseKinematics& pose, int link,
                 const Vector3d& point, const Take& take) {
  const Scalars3 at = scalars(point);
  for_each_above(morphology, pose, link, [&](int c, const Twist& twist) {
    take(c, cross(scalars(twist.turn), at) + scalars(twist.shift));
  });
}

template <class Take>
void direction_rates(const Morphology& morphology, const PoseKinematics& pose, int link,
                     const Vector3d& direction, const Take& take) {
  const Scalars3 along = scalars(direction);
  for_each_above(morphology, pose, link,
                 [&](int c, const Twist& twist) { take(c, cross(scalars(twist.turn), along)); });
}

/// Calls visit(coordinate, its twist, the lower one of its link and `link`) for all that moves a
/// link or something below it.
template <class Visit>
void for_each_related(const Ancestry& ancestry, const PoseKinematics& pose, int link,
                      int link_count, Visit visit) {
  for (int c = 0; c < 6; ++c) visit(c, pose.twist_of(c), link);
  for (int l = 1; l < link_count; ++l)
    if (ancestry.related(link, l)) visit(5 + l, pose.twist_of(5 + l), std::max(link, l));
}

template <class Take>
void first_moment_rates(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                        const PoseKinematics& pose, int link, double scale, const Take& take) {
  const int count = static_cast<int>(geometry.links.size());
  for_each_related(ancestry, pose, link, count, [&](int c, const Twist& twist, int lower) {
    const double mass = geometry.mass_below[static_cast<std::size_t>(lower)];
    take(c, scale * (cross(scalars(twist.turn), scalars(pose.first_moment(lower))) +
                     mass * scalars(twist.shift)));
  });
}

template <class Take>
void swept_rates(const Ancestry& ancestry, const PairMoments& moments, int link,
                 const PoseKinematics& first, const PoseKinematics& second, const Take& take_first,
                 const Take& take_second) {
  const int count = moments.link_count();
  for_each_related(ancestry, first, link, count, [&](int c, const Twist& twist, int lower) {
    take_first(c, swept_rate(scalars(twist.turn), moments.below(lower), scalars(twist.shift),
                             scalars(second.first_moment(lower))));
  });
  for_each_related(ancestry, second, link, count, [&](int c, const Twist& twist, int lower) {
    take_second(c, -swept_rate(scalars(twist.turn), moments.below(lower).transpose(),
                               scalars(twist.shift), scalars(first.first_moment(lower))));
  });
}

template <class Take>
void foot_turn_rates(const Morphology& morphology, int foot, const PoseKinematics& first,
                     const PoseKinematics& second, const Take& take_first,
                     const Take& take_second) {
  const int link = morphology.feet[static_cast<std::size_t>(foot)].link;
  const Matrix3d swept = turn_moments(first, second, link);
  const Scalars3 none{0.0, 0.0, 0.0};  // directions turn but do not shift
  for_each_above(morphology, first, link, [&](int c, const Twist& twist) {
    take_first(c, swept_rate(scalars(twist.turn), swept, none, none));
  });
  for_each_above(morphology, second, link, [&](int c, const Twist& twist) {
    take_second(c, -swept_rate(scalars(twist.turn), swept.transpose(), none, none));
  });
}

}  // namespace

void add_point_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                        const Vector3d& point, const Vector3d& multiplier, double* gradient) {
  point_rates(morphology, pose, link, point, GradientOf{scalars(multiplier), gradient});
}

void add_point_jacobian(const Morphology& morphology, const PoseKinematics& pose, int link,
                        const Vector3d& point, const Columns& columns, Eigen::MatrixXd& jacobian) {
  point_rates(morphology, pose, link, point, JacobianOf{columns, jacobian});
}

void add_trunk_point_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                              const Vector3d& at, const Vector3d& multiplier, double* gradient) {
  const Matrix3d& trunk = pose.rotation(0);
  const Vector3d point = pose.origin(0) + trunk * at;
  const Scalars3 p = scalars(point);
  const GradientOf take{scalars(multiplier), gradient};
  for (; link > 0; link = morphology.links[static_cast<std::size_t>(link)].parent) {
    const Twist& twist = pose.twist_of(5 + link);
    const Scalars3 rate = cross(scalars(twist.turn), p) + scalars(twist.shift);
    take(5 + link, transposed_product(trunk, rate));
  }
}

void add_direction_gradient(const Morphology& morphology, const PoseKinematics& pose, int link,
                            const Vector3d& direction, const Vector3d& multiplier,
                            double* gradient) {
  direction_rates(morphology, pose, link, direction, GradientOf{scalars(multiplier), gradient});
}

void add_direction_jacobian(const Morphology& morphology, const PoseKinematics& pose, int link,
                            const Vector3d& direction, const Columns& columns,
                            Eigen::MatrixXd& jacobian) {
  direction_rates(morphology, pose, link, direction, JacobianOf{columns, jacobian});
}

void add_first_moment_gradient(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                               const PoseKinematics& pose, int link, double scale,
                               const Vector3d& multiplier, double* gradient) {
  first_moment_rates(geometry, ancestry, pose, link, scale,
                     GradientOf{scalars(multiplier), gradient});
}

void add_first_moment_jacobian(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                               const PoseKinematics& pose, int link, double scale,
                               const Columns& columns, Eigen::MatrixXd& jacobian) {
  first_moment_rates(geometry, ancestry, pose, link, scale, JacobianOf{columns, jacobian});
}

void add_swept_momentum_gradient(const Ancestry& ancestry, const PairMoments& moments, int link,
                                 const PoseKinematics& first, const PoseKinematics& second,
                                 const Vector3d& multiplier, double* first_gradient,
                                 double* second_gradient) {
  const Scalars3 mu = scalars(multiplier);
  swept_rates(ancestry, moments, link, first, second, GradientOf{mu, first_gradient},
              GradientOf{mu, second_gradient});
}

void add_swept_momentum_jacobian(const Ancestry& ancestry, const PairMoments& moments, int link,
                                 const PoseKinematics& first, const PoseKinematics& second,
                                 const Columns& first_columns, const Columns& second_columns,
                                 Eigen::MatrixXd& jacobian) {
  swept_rates(ancestry, moments, link, first, second, JacobianOf{first_columns, jacobian},
              JacobianOf{second_columns, jacobian});
}

void add_foot_turn_gradient(const Morphology& morphology, int foot, const PoseKinematics& first,
                            const PoseKinematics& second, const Vector3d& multiplier,
                            double* first_gradient, double* second_gradient) {
  const Scalars3 mu = scalars(multiplier);
  foot_turn_rates(morphology, foot, first, second, GradientOf{mu, first_gradient},
                  GradientOf{mu, second_gradient});
}

void add_foot_turn_jacobian(const Morphology& morphology, int foot, const PoseKinematics& first,
                            const PoseKinematics& second, const Columns& first_columns,
                            const Columns& second_columns, Eigen::MatrixXd& jacobian) {
  foot_turn_rates(morphology, foot, first, second, JacobianOf{first_columns, jacobian},
                  JacobianOf{second_columns, jacobian});
}

}  // namespace legwright
