// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/kinematics.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "optimizer/design/rotation.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix34 = Eigen::Matrix<double, 3, 4>;

/// Adds `value` for the unordered pair of columns (a, b); a shared column counts both orders.
void add_pair(Eigen::MatrixXd& hessian, int a, int b, double value) {
  hessian(a, b) += value;
  hessian(b, a) += value;
}

}  // namespace

Ancestry::Ancestry(const Morphology& morphology) {
  const int n = static_cast<int>(morphology.links.size());
  table_.setConstant(n, n, false);
  for (int lower = 0; lower < n; ++lower)
    for (int upper = lower; upper >= 0; upper = morphology.links[upper].parent)
      table_(upper, lower) = true;
}

Eigen::Matrix4d PoseKinematics::transform(int link) const {
  Eigen::Matrix4d t = Eigen::Matrix4d::Identity();
  t.topLeftCorner<3, 3>() = rotation_[link];
  t.topRightCorner<3, 1>() = origin_[link];
  return t;
}

void PoseKinematics::add_translation(int link, int coordinate, const Vector3d& rate) {
  Matrix34 velocity = Matrix34::Zero();
  velocity.col(3) = rate;
  movers_.push_back({coordinate, Mover::Kind::translation, link, Vector3d::Zero(), velocity});
}

void PoseKinematics::add_rotation(int link, int coordinate, const Vector3d& turn) {
  Matrix34 velocity;
  velocity.leftCols<3>() = skew(turn);
  velocity.col(3) = -turn.cross(origin_[link]);
  movers_.push_back({coordinate, Mover::Kind::rotation, link, turn, velocity});
}

void PoseKinematics::add_root(const Eigen::VectorXd& q) {
  RotationDerivatives root;
  rotation_of_vector(q.segment<3>(3), true, root);
  rotation_[0] = root.rotation;
  origin_[0] = q.head<3>();
  for (int a = 0; a < 3; ++a) add_translation(0, a, Vector3d::Unit(a));
  const int first = static_cast<int>(movers_.size());
  for (int a = 0; a < 3; ++a) add_rotation(0, 3 + a, root.turn[a]);
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) seconds_.push_back({first + a, first + b, root.second[a][b]});
}

void PoseKinematics::add_joint_movers(int index, const AxisAtDesign& at, double angle,
                                      const Matrix3d& before, int design_start, bool with_design) {
  // R(a, q) = cos q I + sin q [a]× + (1 − cos q) a aᵀ, its derivatives written as [turn]× R and second · R.
  const Vector3d& a = at.axis;
  const double c = std::cos(angle), s = std::sin(angle);
  const Matrix3d inverse = rotation_about(a, angle).transpose();
  const auto world = [&](const Matrix3d& m) -> Matrix3d {
    return before * (m * inverse) * before.transpose();
  };
  const auto symmetric = [](const Vector3d& v, const Vector3d& w) -> Matrix3d {
    return v * w.transpose() + w * v.transpose();
  };
  const int first = static_cast<int>(movers_.size());
  const Vector3d axis_W = before * a;
  add_rotation(index, 5 + index, axis_W);
  seconds_.push_back({first, first, skew(axis_W) * skew(axis_W)});
  if (!with_design) return;
  const int count = static_cast<int>(at.parameters.size());
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

void PoseKinematics::add_link(const Link& link, int index, const LinkAtDesign& at, double angle,
                              int design_start, bool with_design) {
  const Matrix3d& parent = rotation_[link.parent];
  origin_[index] = origin_[link.parent] + parent * at.origin;
  if (with_design)
    for (const AffineVector::Slope& slope : link.origin.slopes)
      add_translation(index, design_start + slope.parameter, parent * slope.slope);
  const Matrix3d before = parent * link.orientation;
  rotation_[index] = before * rotation_about(at.axis.axis, angle);
  add_joint_movers(index, at.axis, angle, before, design_start, with_design);
}

void PoseKinematics::compute(const Morphology& morphology, const GeometryAtDesign& geometry,
                             const Eigen::VectorXd& q, bool with_design) {
  const int link_count = static_cast<int>(morphology.links.size());
  const int design_start = morphology.pose_size();
  rotation_.resize(link_count);
  origin_.resize(link_count);
  with_design_ = with_design;
  movers_.clear();
  seconds_.clear();
  add_root(q);
  for (int l = 1; l < link_count; ++l)
    add_link(morphology.links[l], l, geometry.links[l], q[5 + l], design_start, with_design);
  if (!with_design) return;
  for (int l = 0; l < link_count; ++l)
    for (std::size_t k = 0; k < geometry.links[l].inner.size(); ++k) {
      Mover mover{design_start + geometry.links[l].inner[k].parameter, Mover::Kind::inner, l,
                  Vector3d::Zero(), Matrix34::Zero()};
      mover.inner_index = static_cast<int>(k);
      movers_.push_back(mover);
    }
}

PoseKinematics PoseKinematics::moved(const Matrix3d& turn, const Vector3d& shift) const {
  PoseKinematics out = *this;
  for (std::size_t l = 0; l < origin_.size(); ++l) {
    out.origin_[l] = turn * origin_[l] + shift;
    out.rotation_[l] = turn * rotation_[l];
  }
  for (Mover& mover : out.movers_) {
    mover.turn = turn * mover.turn;
    if (mover.kind == Mover::Kind::translation)
      mover.velocity.col(3) = turn * mover.velocity.col(3).eval();
    if (mover.kind != Mover::Kind::rotation) continue;
    mover.velocity.leftCols<3>() = skew(mover.turn);
    mover.velocity.col(3) = -mover.turn.cross(out.origin_[mover.link]);
  }
  for (SameLinkSecond& second : out.seconds_)
    second.second = turn * second.second * turn.transpose();
  return out;
}

void PointDerivatives::add_jacobian(Eigen::Ref<Eigen::Matrix3Xd> jacobian) const {
  for (const Effect& effect : effects) jacobian.col(effect.column) += effect.rate;
}

void PointDerivatives::add_curvature(const Ancestry& ancestry, const Vector3d& multiplier,
                                     Eigen::MatrixXd& hessian) const {
  for (const Effect& upper : effects) {
    if (!upper.rotates) continue;
    const Vector3d lever = multiplier.cross(upper.turn);  // μ·(turn × rate) = (μ × turn)·rate
    for (const Effect& lower : effects)
      if (ancestry.strictly_above(upper.link, lower.link) ||
          (lower.inner && upper.link == lower.link))
        add_pair(hessian, upper.column, lower.column, lever.dot(lower.rate));
  }
  for (const Second& second : seconds) {
    const double curvature = multiplier.dot(second.rate);
    if (second.same)
      hessian(second.a, second.a) += curvature;
    else
      add_pair(hessian, second.a, second.b, curvature);
  }
}

void foot_from_pose(const Morphology& morphology, const GeometryAtDesign& geometry,
                    const Ancestry& ancestry, const PoseKinematics& pose, int foot,
                    const Columns& columns, PointDerivatives& out) {
  const Foot& data = morphology.feet[foot];
  const Vector3d p = pose.origin(data.link) + pose.rotation(data.link) * geometry.feet[foot];
  out.value = p;
  out.effects.clear();
  out.seconds.clear();
  for (const Mover& mover : pose.movers()) {
    if (mover.kind == Mover::Kind::inner || !ancestry.contains(mover.link, data.link)) continue;
    out.effects.push_back({columns[mover.coordinate], mover.link,
                           mover.kind == Mover::Kind::rotation, false, mover.turn,
                           mover.velocity * p.homogeneous()});
  }
  if (pose.with_design())
    for (const AffineVector::Slope& slope : data.position.slopes)
      out.effects.push_back({columns[morphology.pose_size() + slope.parameter], data.link, false,
                             true, Vector3d::Zero(), pose.rotation(data.link) * slope.slope});
  for (const SameLinkSecond& second : pose.same_link_seconds()) {
    const Mover &a = pose.movers()[second.a], &b = pose.movers()[second.b];
    if (!ancestry.contains(a.link, data.link)) continue;
    out.seconds.push_back({columns[a.coordinate], columns[b.coordinate],
                           second.second * (p - pose.origin(a.link)), second.a == second.b});
  }
}

void com_from_pose(const Morphology& morphology, const GeometryAtDesign& geometry,
                   const PoseKinematics& pose, const Columns& columns, PointDerivatives& out) {
  // Share of the mass, and of mass times position, of each link with all below it.
  const int link_count = static_cast<int>(geometry.links.size());
  std::vector<Eigen::Vector4d> below(link_count);
  for (int l = 0; l < link_count; ++l)
    below[l] = pose.transform(l) * geometry.links[l].moments.col(3) / geometry.total_mass;
  for (int l = link_count - 1; l > 0; --l) below[morphology.links[l].parent] += below[l];
  out.value = below[0].head<3>();
  out.effects.clear();
  out.seconds.clear();
  for (const Mover& mover : pose.movers()) {
    const bool inner = mover.kind == Mover::Kind::inner;
    const Vector3d rate = inner
                              ? Vector3d(pose.rotation(mover.link) *
                                         geometry.links[mover.link].inner[mover.inner_index].first /
                                         geometry.total_mass)
                              : Vector3d(mover.velocity * below[mover.link]);
    out.effects.push_back({columns[mover.coordinate], mover.link,
                           mover.kind == Mover::Kind::rotation, inner, mover.turn, rate});
  }
  for (const SameLinkSecond& second : pose.same_link_seconds()) {
    const Mover &a = pose.movers()[second.a], &b = pose.movers()[second.b];
    const Eigen::Vector4d& sum = below[a.link];
    out.seconds.push_back({columns[a.coordinate], columns[b.coordinate],
                           second.second * (sum.head<3>() - sum[3] * pose.origin(a.link)),
                           second.a == second.b});
  }
}

}  // namespace legwright
