// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/kinematics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "optimizer/design/rotation.hpp"
#include "optimizer/design/small_products.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

}  // namespace

PoseKinematics home_pose(const Morphology& morphology, const GeometryAtDesign& geometry) {
  Eigen::VectorXd q = Eigen::VectorXd::Zero(morphology.pose_size());
  q.tail(morphology.joint_count()) = morphology.nominal_joints();
  PoseKinematics home;
  home.compute(morphology, geometry, q, PoseDetail::place);
  return home;
}

Ancestry::Ancestry(const Morphology& morphology) {
  const int n = static_cast<int>(morphology.links.size());
  table_.setConstant(n, n, false);
  for (int lower = 0; lower < n; ++lower)
    for (int upper = lower; upper >= 0; upper = morphology.links[upper].parent)
      table_(upper, lower) = true;
  chains_.resize(morphology.links.size());
  for (int lower = 0; lower < n; ++lower)
    for (int upper = 0; upper <= lower; ++upper)  // parents come before their children
      if (table_(upper, lower)) chains_[static_cast<std::size_t>(lower)].push_back(upper);
}

void PoseKinematics::add_translation(int link, int coordinate, const Vector3d& rate) {
  twists_.push_back({coordinate, Twist::Kind::translation, link, Vector3d::Zero(), rate});
}

void PoseKinematics::add_rotation(int link, int coordinate, const Vector3d& turn) {
  Twist& twist = twists_.emplace_back();
  twist.coordinate = coordinate;
  twist.kind = Twist::Kind::rotation;
  twist.link = link;
  const Scalars3 axis = scalars(turn);
  store(axis, twist.turn);
  store(-cross(axis, scalars(origin_[link])), twist.shift);
}

void PoseKinematics::add_root(const RotationDerivatives& root) {
  for (int a = 0; a < 3; ++a) add_translation(0, a, Vector3d::Unit(a));
  const int first = static_cast<int>(twists_.size());
  for (int a = 0; a < 3; ++a) add_rotation(0, 3 + a, root.turn[a]);
  if (!with_second()) return;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) seconds_.push_back({first + a, first + b, root.second[a][b]});
}

void PoseKinematics::add_joint_twists(int index, const AxisAtDesign& at, double angle,
                                      int design_start) {
  // R(a, q) = cos q I + sin q [a]× + (1 − cos q) a aᵀ, its derivatives written as [turn]× R and
  // second · R.
  const int first = static_cast<int>(twists_.size());
  const Matrix3d& before = before_[index];
  const Vector3d& a = at.axis;
  const Vector3d axis_W = before * a;
  add_rotation(index, 5 + index, axis_W);
  if (!with_second()) return;
  seconds_.push_back({first, first, axis_W * axis_W.transpose() - Matrix3d::Identity()});
  const int count = static_cast<int>(at.parameters.size());
  if (!with_design() || count == 0) return;
  const double c = std::cos(angle), s = std::sin(angle);
  const Matrix3d inverse = rotation_about(a, angle).transpose();
  const auto world = [&](const Matrix3d& m) -> Matrix3d {
    return before * (m * inverse) * before.transpose();
  };
  const auto symmetric = [](const Vector3d& v, const Vector3d& w) -> Matrix3d {
    return v * w.transpose() + w * v.transpose();
  };
  for (int k = 0; k < count; ++k) {
    const Matrix3d turned = s * skew(at.first[k]) + (1 - c) * symmetric(a, at.first[k]);
    add_rotation(index, design_start + at.parameters[k], before * unskew(turned * inverse));
    const Matrix3d with_angle = c * skew(at.first[k]) + s * symmetric(a, at.first[k]);
    seconds_.push_back({first, first + 1 + k, world(with_angle)});
  }
  for (int k = 0; k < count; ++k)
    for (int l = k; l < count; ++l) {
      const Matrix3d both =
          s * skew(at.second[k][l]) +
          (1 - c) * (symmetric(at.first[k], at.first[l]) + symmetric(a, at.second[k][l]));
      seconds_.push_back({first + 1 + k, first + 1 + l, world(both)});
    }
}

void PoseKinematics::place(const Morphology& morphology, const GeometryAtDesign& geometry,
                           const Eigen::Ref<const Eigen::VectorXd>& q) {
  const std::size_t link_count = morphology.links.size();
  rotation_.resize(link_count);
  before_.resize(link_count);
  origin_.resize(link_count);
  for (std::size_t l = 1; l < link_count; ++l) {
    const Link& link = morphology.links[l];
    const LinkAtDesign& at = geometry.links[l];
    const Matrix3d& parent = rotation_[link.parent];
    store(scalars(origin_[link.parent]) + product(parent, scalars(at.origin)), origin_[l]);
    const Matrix3d turned = rotation_about(at.axis.axis, q[5 + static_cast<Eigen::Index>(l)]);
    for (int k = 0; k < 3; ++k)
      store(product(parent, scalars(link.orientation.col(k))), before_[l].col(k));
    for (int k = 0; k < 3; ++k)
      store(product(before_[l], scalars(turned.col(k))), rotation_[l].col(k));
  }
}

void PoseKinematics::sum_moments(const Morphology& morphology, const GeometryAtDesign& geometry) {
  const std::size_t link_count = morphology.links.size();
  moments_.resize(link_count);
  first_moment_.resize(link_count);
  for (std::size_t l = 0; l < link_count; ++l) {
    const Eigen::Matrix4d& own = geometry.links[l].moments;
    const Scalars3 origin = scalars(origin_[l]);
    const auto moment = [&](int k) {
      return product(rotation_[l], scalars(own.col(k))) + own(3, k) * origin;
    };
    for (int k = 0; k < 3; ++k) store(moment(k), moments_[l].col(k));
    const Scalars3 sum = moment(3);
    store(sum, moments_[l].col(3));
    store(sum, first_moment_[l]);
  }
  for (std::size_t l = link_count - 1; l > 0; --l)
    first_moment_[morphology.links[l].parent] += first_moment_[l];
}

void PoseKinematics::compute(const Morphology& morphology, const GeometryAtDesign& geometry,
                             const Eigen::Ref<const Eigen::VectorXd>& q, PoseDetail detail) {
  const int link_count = static_cast<int>(morphology.links.size());
  const int design_start = morphology.pose_size();
  detail_ = detail;
  twists_.clear();
  seconds_.clear();
  rotation_.resize(link_count);
  origin_.resize(link_count);
  RotationDerivatives root;
  rotation_of_vector(q.segment<3>(3),
                     with_second()                 ? 2
                     : detail == PoseDetail::rates ? 1
                                                   : 0,
                     root);
  rotation_[0] = root.rotation;
  origin_[0] = q.head<3>();
  place(morphology, geometry, q);
  sum_moments(morphology, geometry);
  if (detail == PoseDetail::place) return;
  add_root(root);
  for (int l = 1; l < link_count; ++l) {
    if (with_design())
      for (const AffineVector::Slope& slope : morphology.links[l].origin.slopes)
        add_translation(l, design_start + slope.parameter,
                        rotation_[morphology.links[l].parent] * slope.slope);
    add_joint_twists(l, geometry.links[l].axis, q[5 + l], design_start);
  }
  if (!with_design()) return;
  for (int l = 0; l < link_count; ++l)
    for (std::size_t k = 0; k < geometry.links[l].inner.size(); ++k)
      twists_.push_back({design_start + geometry.links[l].inner[k].parameter, Twist::Kind::inner, l,
                         Vector3d::Zero(), Vector3d::Zero(), static_cast<int>(k)});
}

void PoseKinematics::assign_moved(const PoseKinematics& other, const GeometryAtDesign& geometry,
                                  const Matrix3d& turn, const Vector3d& shift) {
  *this = other;
  for (std::size_t l = 0; l < origin_.size(); ++l) {
    origin_[l] = turn * other.origin_[l] + shift;
    rotation_[l] = turn * other.rotation_[l];
    before_[l] = turn * other.before_[l];
    moments_[l] = turn * other.moments_[l] + shift * geometry.links[l].moments.row(3);
    first_moment_[l] = turn * other.first_moment_[l] + geometry.mass_below[l] * shift;
  }
  for (Twist& twist : twists_) {
    twist.turn = turn * twist.turn.eval();
    if (twist.kind == Twist::Kind::rotation)
      twist.shift = -twist.turn.cross(origin_[twist.link]);
    else
      twist.shift = turn * twist.shift.eval();
  }
  for (SameLinkSecond& second : seconds_) second.second = turn * second.second * turn.transpose();
}

}  // namespace legwright
