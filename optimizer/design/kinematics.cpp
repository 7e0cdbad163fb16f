// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/kinematics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "optimizer/design/rotation.hpp"

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
}

void PoseKinematics::add_translation(int link, int coordinate, const Vector3d& rate) {
  movers_.push_back({coordinate, Mover::Kind::translation, link, Vector3d::Zero(), rate});
}

void PoseKinematics::add_rotation(int link, int coordinate, const Vector3d& turn) {
  movers_.push_back({coordinate, Mover::Kind::rotation, link, turn, -turn.cross(origin_[link])});
}

void PoseKinematics::add_root(const RotationDerivatives& root) {
  for (int a = 0; a < 3; ++a) add_translation(0, a, Vector3d::Unit(a));
  const int first = static_cast<int>(movers_.size());
  for (int a = 0; a < 3; ++a) add_rotation(0, 3 + a, root.turn[a]);
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) seconds_.push_back({first + a, first + b, root.second[a][b]});
}

void PoseKinematics::add_joint_movers(int index, const AxisAtDesign& at, double angle,
                                      int design_start) {
  // R(a, q) = cos q I + sin q [a]× + (1 − cos q) a aᵀ, its derivatives written as [turn]× R and second · R.
  const int first = static_cast<int>(movers_.size());
  const Matrix3d& before = before_[index];
  const Vector3d& a = at.axis;
  const Vector3d axis_W = before * a;
  add_rotation(index, 5 + index, axis_W);
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
    origin_[l] = origin_[link.parent] + rotation_[link.parent] * at.origin;
    before_[l].noalias() = rotation_[link.parent] * link.orientation;
    rotation_[l].noalias() =
        before_[l] * rotation_about(at.axis.axis, q[5 + static_cast<Eigen::Index>(l)]);
  }
}

void PoseKinematics::sum_moments(const Morphology& morphology, const GeometryAtDesign& geometry) {
  const std::size_t link_count = morphology.links.size();
  moments_.resize(link_count);
  first_moment_.resize(link_count);
  for (std::size_t l = 0; l < link_count; ++l) {
    const Eigen::Matrix4d& own = geometry.links[l].moments;
    moments_[l].noalias() = rotation_[l] * own.topRows<3>();
    moments_[l] += origin_[l] * own.row(3);
    first_moment_[l] = moments_[l].col(3);
  }
  for (std::size_t l = link_count - 1; l > 0; --l)
    first_moment_[morphology.links[l].parent] += first_moment_[l];
}

void PoseKinematics::compute(const Morphology& morphology, const GeometryAtDesign& geometry,
                             const Eigen::Ref<const Eigen::VectorXd>& q, PoseDetail detail) {
  const int link_count = static_cast<int>(morphology.links.size());
  const int design_start = morphology.pose_size();
  detail_ = detail;
  movers_.clear();
  seconds_.clear();
  rotation_.resize(link_count);
  origin_.resize(link_count);
  RotationDerivatives root;
  rotation_of_vector(q.segment<3>(3), detail != PoseDetail::place, root);
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
    add_joint_movers(l, geometry.links[l].axis, q[5 + l], design_start);
  }
  if (!with_design()) return;
  for (int l = 0; l < link_count; ++l)
    for (std::size_t k = 0; k < geometry.links[l].inner.size(); ++k)
      movers_.push_back({design_start + geometry.links[l].inner[k].parameter, Mover::Kind::inner, l,
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
  for (Mover& mover : movers_) {
    mover.turn = turn * mover.turn.eval();
    if (mover.kind == Mover::Kind::rotation)
      mover.shift = -mover.turn.cross(origin_[mover.link]);
    else
      mover.shift = turn * mover.shift.eval();
  }
  for (SameLinkSecond& second : seconds_) second.second = turn * second.second * turn.transpose();
}

void PointDerivatives::clear(const Vector3d& at) {
  value = at;
  effects.clear();
  seconds.clear();
  growths.clear();
  growth_seconds.clear();
}

void PointDerivatives::add_jacobian(Eigen::MatrixXd& jacobian) const {
  for (const Effect& effect : effects)
    for (int k = 0; k < 3; ++k) jacobian(effect.column, k) += effect.rate[k];
  for (const Growth& growth : growths)
    for (int k = 0; k < 3; ++k) jacobian(growth.column, k) -= growth.slope * value[k];
}

void PointDerivatives::add_quotient_curvature(const Vector3d& multiplier,
                                              Eigen::MatrixXd& hessian) const {
  // y = N/M: y_kl = (N_kl − y_k M_l − y_l M_k − y M_kl)/M.
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(hessian.rows(), 3);
  add_jacobian(jacobian);
  const Eigen::VectorXd pulled = jacobian * multiplier;
  for (const Growth& growth : growths)
    for (int c = 0; c < pulled.size(); ++c)
      if (pulled[c] != 0.0) add_pair(hessian, c, growth.column, -growth.slope * pulled[c]);
  const double along = multiplier.dot(value);
  for (const GrowthSecond& second : growth_seconds) {
    if (second.same)
      hessian(second.a, second.a) -= along * second.second;
    else
      add_pair(hessian, second.a, second.b, -along * second.second);
  }
}

void PointDerivatives::add_curvature(const Ancestry& ancestry, const Vector3d& multiplier,
                                     Eigen::MatrixXd& hessian) const {
  for (std::size_t k = 0; k < effects.size(); ++k) {
    const Effect& lower = effects[k];
    const Vector3d lever = lower.rate.cross(multiplier);  // μ·(turn × rate) = turn·(rate × μ)
    const bool* above = ancestry.above(lower.link);
    for (std::size_t l = 0; l < k; ++l) {  // upper movers come first
      const Effect& upper = effects[l];
      if (upper.rotates && above[upper.link] && (lower.inner || upper.link != lower.link))
        add_pair(hessian, upper.column, lower.column, lever.dot(upper.turn));
      if (lower.growth != 0.0 && above[upper.link] && !upper.inner)
        add_pair(hessian, upper.column, lower.column, lower.growth * multiplier.dot(upper.shift));
    }
  }
  if (!growths.empty()) add_quotient_curvature(multiplier, hessian);
  for (const Second& second : seconds) {
    const double curvature = multiplier.dot(second.rate);
    if (second.same)
      hessian(second.a, second.a) += curvature;
    else
      add_pair(hessian, second.a, second.b, curvature);
  }
}

namespace {

/// What the movers of `pose` for which `moves(link)` do to the world point `out.value`.
template <class Moves>
void add_rigid_effects(const PoseKinematics& pose, const Columns& columns, Moves moves,
                       PointDerivatives& out) {
  const Vector3d p = out.value;
  for (const Mover& mover : pose.movers()) {
    if (mover.kind == Mover::Kind::inner || !moves(mover)) continue;
    out.effects.push_back({columns[mover.coordinate], mover.link,
                           mover.kind == Mover::Kind::rotation, false, mover.turn,
                           mover.turn.cross(p) + mover.shift});
  }
  for (const SameLinkSecond& second : pose.same_link_seconds()) {
    const Mover &a = pose.movers()[second.a], &b = pose.movers()[second.b];
    if (!moves(a)) continue;
    out.seconds.push_back({columns[a.coordinate], columns[b.coordinate],
                           second.second * (p - pose.origin(a.link)), second.a == second.b});
  }
}

/// What moves the world point `out.value`, which sits at `own` in the frame of a link.
void add_point_effects(const Morphology& morphology, const Ancestry& ancestry,
                       const PoseKinematics& pose, int link, const AffineVector& own,
                       const Columns& columns, PointDerivatives& out) {
  add_rigid_effects(
      pose, columns, [&](const Mover& m) { return ancestry.contains(m.link, link); }, out);
  if (!pose.with_design()) return;
  for (const AffineVector::Slope& slope : own.slopes)
    out.effects.push_back({columns[morphology.pose_size() + slope.parameter], link, false, true,
                           Vector3d::Zero(), pose.rotation(link) * slope.slope});
}

}  // namespace

Vector3d foot_place(const Morphology& morphology, const GeometryAtDesign& geometry,
                    const PoseKinematics& pose, int foot) {
  const int link = morphology.feet[foot].link;
  return pose.origin(link) + pose.rotation(link) * geometry.feet[foot];
}

void foot_from_pose(const Morphology& morphology, const GeometryAtDesign& geometry,
                    const Ancestry& ancestry, const PoseKinematics& pose, int foot,
                    const Columns& columns, PointDerivatives& out) {
  const Foot& data = morphology.feet[foot];
  out.clear(foot_place(morphology, geometry, pose, foot));
  add_point_effects(morphology, ancestry, pose, data.link, data.position, columns, out);
}

void direction_from_pose(const Ancestry& ancestry, const PoseKinematics& pose, int link,
                         const Vector3d& own, const Columns& columns, PointDerivatives& out) {
  out.clear(pose.rotation(link) * own);
  const auto turns = [&](const Mover& m) {
    return m.kind == Mover::Kind::rotation && ancestry.contains(m.link, link);
  };
  for (const Mover& mover : pose.movers())
    if (turns(mover))
      out.effects.push_back({columns[mover.coordinate], mover.link, true, false, mover.turn,
                             mover.turn.cross(out.value)});
  for (const SameLinkSecond& second : pose.same_link_seconds()) {
    const Mover &a = pose.movers()[second.a], &b = pose.movers()[second.b];
    if (turns(a))
      out.seconds.push_back({columns[a.coordinate], columns[b.coordinate],
                             second.second * out.value, second.a == second.b});
  }
}

Vector3d capsule_end_place(const Morphology& morphology, const GeometryAtDesign& geometry,
                           const PoseKinematics& pose, int end) {
  const int link = morphology.capsules[end / 2].link;
  return pose.origin(link) + pose.rotation(link) * geometry.capsule_ends[end];
}

void capsule_end_from_pose(const Morphology& morphology, const GeometryAtDesign& geometry,
                           const Ancestry& ancestry, const PoseKinematics& pose, int end,
                           const Columns& columns, PointDerivatives& out) {
  const Capsule& data = morphology.capsules[end / 2];
  out.clear(capsule_end_place(morphology, geometry, pose, end));
  add_point_effects(morphology, ancestry, pose, data.link, end % 2 == 0 ? data.from : data.to,
                    columns, out);
}

void anchor_from_pose(const Ancestry& ancestry, const PoseKinematics& pose, int link,
                      const Columns& columns, PointDerivatives& out) {
  out.clear(pose.origin(link));
  add_rigid_effects(
      pose, columns,
      [&](const Mover& m) {
        return ancestry.strictly_above(m.link, link) ||
               (m.link == link && m.kind == Mover::Kind::translation);
      },
      out);
}

void axis_from_pose(const Morphology& morphology, const GeometryAtDesign& geometry,
                    const Ancestry& ancestry, const PoseKinematics& pose, int link,
                    const Columns& columns, PointDerivatives& out) {
  const AxisAtDesign& axis = geometry.links[link].axis;
  const Matrix3d& before = pose.before(link);
  out.clear(before * axis.axis);
  const auto turns = [&](const Mover& m) {
    return m.kind == Mover::Kind::rotation && ancestry.strictly_above(m.link, link);
  };
  for (const Mover& mover : pose.movers())
    if (turns(mover))
      out.effects.push_back({columns[mover.coordinate], mover.link, true, false, mover.turn,
                             mover.turn.cross(out.value)});
  for (const SameLinkSecond& second : pose.same_link_seconds()) {
    const Mover &a = pose.movers()[second.a], &b = pose.movers()[second.b];
    if (turns(a))
      out.seconds.push_back({columns[a.coordinate], columns[b.coordinate],
                             second.second * out.value, second.a == second.b});
  }
  if (!pose.with_design()) return;
  for (std::size_t k = 0; k < axis.parameters.size(); ++k) {
    const int column = columns[morphology.pose_size() + axis.parameters[k]];
    out.effects.push_back({column, link, false, false, Vector3d::Zero(), before * axis.first[k]});
    for (std::size_t l = k; l < axis.parameters.size(); ++l)
      out.seconds.push_back({column, columns[morphology.pose_size() + axis.parameters[l]],
                             before * axis.second[k][l], k == l});
  }
}

void first_moment_from_pose(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                            const PoseKinematics& pose, int link, double scale,
                            const Columns& columns, PointDerivatives& out) {
  out.clear(scale * pose.first_moment(link));
  for (const Mover& mover : pose.movers()) {
    if (mover.kind == Mover::Kind::inner) {
      if (!ancestry.contains(link, mover.link)) continue;
      const auto in_world = [&](const Eigen::Vector4d& v) -> Vector3d {
        return scale * (pose.rotation(mover.link) * v.head<3>() + v[3] * pose.origin(mover.link));
      };
      const LinkAtDesign& at = geometry.links[mover.link];
      const InnerMotion& motion = at.inner[mover.inner_index];
      out.effects.push_back({columns[mover.coordinate], mover.link, false, true, Vector3d::Zero(),
                             in_world(motion.first), Vector3d::Zero(), scale * motion.first[3]});
      for (int l = mover.inner_index; at.grows && l < static_cast<int>(at.inner.size()); ++l) {
        const Mover& other =
            (&mover)[l - mover.inner_index];  // inner movers of a link are in a row
        out.seconds.push_back({columns[mover.coordinate], columns[other.coordinate],
                               in_world(motion.second_first(at.inner[l], mover.inner_index, l)),
                               &other == &mover});
      }
    } else if (ancestry.related(link, mover.link)) {
      const int lower = std::max(link, mover.link);  // children come after their parents
      out.effects.push_back({columns[mover.coordinate], mover.link,
                             mover.kind == Mover::Kind::rotation, false, mover.turn,
                             scale * (mover.turn.cross(pose.first_moment(lower)) +
                                      geometry.mass_below[lower] * mover.shift),
                             mover.shift});
    }
  }
  for (const SameLinkSecond& second : pose.same_link_seconds()) {
    const Mover &a = pose.movers()[second.a], &b = pose.movers()[second.b];
    if (!ancestry.related(link, a.link)) continue;
    const int lower = std::max(link, a.link);
    const Vector3d arm =
        pose.first_moment(lower) - geometry.mass_below[lower] * pose.origin(a.link);
    out.seconds.push_back({columns[a.coordinate], columns[b.coordinate],
                           scale * (second.second * arm), second.a == second.b});
  }
}

void com_from_pose(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                   const PoseKinematics& pose, const Columns& columns, PointDerivatives& out) {
  const double scale = 1.0 / geometry.total_mass;
  first_moment_from_pose(geometry, ancestry, pose, 0, scale, columns, out);
  mass_from_pose(geometry, ancestry, pose, 0, scale, columns, out.growths, out.growth_seconds);
}

void mass_from_pose(const GeometryAtDesign& geometry, const Ancestry& ancestry,
                    const PoseKinematics& pose, int link, double scale, const Columns& columns,
                    std::vector<PointDerivatives::Growth>& slopes,
                    std::vector<PointDerivatives::GrowthSecond>& seconds) {
  slopes.clear();
  seconds.clear();
  if (!geometry.grows || !pose.with_design()) return;
  for (const Mover& mover : pose.movers()) {
    if (mover.kind != Mover::Kind::inner || !geometry.links[mover.link].grows ||
        !ancestry.contains(link, mover.link))
      continue;
    const LinkAtDesign& at = geometry.links[mover.link];
    const InnerMotion& motion = at.inner[mover.inner_index];
    slopes.push_back({columns[mover.coordinate], scale * motion.first[3]});
    for (int l = mover.inner_index; l < static_cast<int>(at.inner.size()); ++l) {
      const Mover& other = (&mover)[l - mover.inner_index];
      seconds.push_back({columns[mover.coordinate], columns[other.coordinate],
                         scale * motion.second_first(at.inner[l], mover.inner_index, l)[3],
                         &other == &mover});
    }
  }
}

}  // namespace legwright
