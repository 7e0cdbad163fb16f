// SPDX-License-Identifier: Apache-2.0
// How points, directions and sums over masses move with [q; s]; the poses they belong to are in
// kinematics.cpp.
#include <Eigen/Geometry>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/design/small_products.hpp"

namespace legwright {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void PointDerivatives::clear(const Vector3d& at) {
  value = at;
  effects.clear();
  seconds.clear();
  growths.clear();
  growth_seconds.clear();
}

void PointDerivatives::add(int column, const Twist& twist, const Scalars3& turn,
                           const Scalars3& by_twist) {
  Effect& effect = effects.emplace_back();
  effect.column = column;
  effect.link = twist.link;
  effect.rotates = twist.kind == Twist::Kind::rotation;
  store(turn, effect.turn);
  store(by_twist, effect.rate);
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
  const Scalars3 mu = scalars(multiplier);
  for (std::size_t k = 0; k < effects.size(); ++k) {
    const Effect& lower = effects[k];
    const Scalars3 lever = cross(scalars(lower.rate), mu);  // μ·(turn × rate) = turn·(rate × μ)
    const bool* above = ancestry.above(lower.link);
    for (std::size_t l = 0; l < k; ++l) {  // upper twists come first
      const Effect& upper = effects[l];
      if (upper.rotates && above[upper.link] && (lower.inner || upper.link != lower.link))
        add_pair(hessian, upper.column, lower.column, dot(lever, scalars(upper.turn)));
      if (lower.growth != 0.0 && above[upper.link] && !upper.inner)
        add_pair(hessian, upper.column, lower.column, lower.growth * dot(mu, scalars(upper.shift)));
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

/// What the twists of `pose` for which `moves(link)` do to the world point `out.value`.
template <class Moves>
void add_rigid_effects(const PoseKinematics& pose, const Columns& columns, Moves moves,
                       PointDerivatives& out) {
  const Vector3d p = out.value;
  const Scalars3 at = scalars(p);
  for (const Twist& twist : pose.twists()) {
    if (twist.kind == Twist::Kind::inner || !moves(twist)) continue;
    const Scalars3 turn = scalars(twist.turn);
    out.add(columns[twist.coordinate], twist, turn, cross(turn, at) + scalars(twist.shift));
  }
  for (const SameLinkSecond& second : pose.same_link_seconds()) {
    const Twist &a = pose.twists()[second.a], &b = pose.twists()[second.b];
    if (!moves(a)) continue;
    out.seconds.push_back({columns[a.coordinate], columns[b.coordinate],
                           second.second * (p - pose.origin(a.link)), second.a == second.b});
  }
}

/// What the rotations of `pose` for which `moves(twist)` do to the direction `out.value`.
template <class Moves>
void add_turns(const PoseKinematics& pose, const Columns& columns, Moves moves,
               PointDerivatives& out) {
  const auto turns = [&](const Twist& m) { return m.kind == Twist::Kind::rotation && moves(m); };
  const Scalars3 along = scalars(out.value);
  for (const Twist& twist : pose.twists()) {
    if (!turns(twist)) continue;
    const Scalars3 turn = scalars(twist.turn);
    out.add(columns[twist.coordinate], twist, turn, cross(turn, along));
  }
  for (const SameLinkSecond& second : pose.same_link_seconds()) {
    const Twist &a = pose.twists()[second.a], &b = pose.twists()[second.b];
    if (turns(a))
      out.seconds.push_back({columns[a.coordinate], columns[b.coordinate],
                             second.second * out.value, second.a == second.b});
  }
}

/// What moves the world point `out.value`, which sits at `own` in the frame of a link: the twists
/// for which `moves(twist)`, and the design within the link.
template <class Moves>
void add_point_effects(const Morphology& morphology, const PoseKinematics& pose, int link,
                       Moves moves, const AffineVector& own, const Columns& columns,
                       PointDerivatives& out) {
  add_rigid_effects(pose, columns, moves, out);
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
  add_point_effects(
      morphology, pose, data.link,
      [&](const Twist& m) { return ancestry.contains(m.link, data.link); }, data.position, columns,
      out);
}

void direction_from_pose(const Ancestry& ancestry, const PoseKinematics& pose, int link,
                         const Vector3d& own, const Columns& columns, PointDerivatives& out) {
  out.clear(pose.rotation(link) * own);
  add_turns(
      pose, columns, [&](const Twist& m) { return ancestry.contains(m.link, link); }, out);
}

Vector3d capsule_end_place(const Morphology& morphology, const GeometryAtDesign& geometry,
                           const PoseKinematics& pose, int end) {
  const int link = morphology.capsules[end / 2].link;
  return pose.origin(link) + pose.rotation(link) * geometry.capsule_ends[end];
}

Vector3d place_from_trunk(const PoseKinematics& pose, int link, const Vector3d& own) {
  if (link == 0) return own;
  return pose.rotation(0).transpose() *
         (pose.origin(link) + pose.rotation(link) * own - pose.origin(0));
}

void point_from_trunk(const Morphology& morphology, const Ancestry& ancestry,
                      const PoseKinematics& pose, int link, const Vector3d& at,
                      const AffineVector& own, const Columns& columns, PointDerivatives& out) {
  // As in the world, without what moves the trunk; then all vectors are turned into its frame. A
  // common turn of rates and twists leaves the curvature's products as they are.
  const Matrix3d& trunk = pose.rotation(0);
  out.clear(pose.origin(0) + trunk * at);
  const auto moves = [&](const Twist& m) { return m.link > 0 && ancestry.contains(m.link, link); };
  add_point_effects(morphology, pose, link, moves, own, columns, out);
  out.value = at;
  for (PointDerivatives::Effect& effect : out.effects) {
    store(transposed_product(trunk, scalars(effect.turn)), effect.turn);
    store(transposed_product(trunk, scalars(effect.rate)), effect.rate);
  }
  for (PointDerivatives::Second& second : out.seconds)
    store(transposed_product(trunk, scalars(second.rate)), second.rate);
}

void anchor_from_pose(const Ancestry& ancestry, const PoseKinematics& pose, int link,
                      const Columns& columns, PointDerivatives& out) {
  out.clear(pose.origin(link));
  add_rigid_effects(
      pose, columns,
      [&](const Twist& m) {
        return ancestry.strictly_above(m.link, link) ||
               (m.link == link && m.kind == Twist::Kind::translation);
      },
      out);
}

void axis_from_pose(const Morphology& morphology, const GeometryAtDesign& geometry,
                    const Ancestry& ancestry, const PoseKinematics& pose, int link,
                    const Columns& columns, PointDerivatives& out) {
  const AxisAtDesign& axis = geometry.links[link].axis;
  const Matrix3d& before = pose.before(link);
  out.clear(before * axis.axis);
  add_turns(
      pose, columns, [&](const Twist& m) { return ancestry.strictly_above(m.link, link); }, out);
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
  for (const Twist& twist : pose.twists()) {
    if (twist.kind == Twist::Kind::inner) {
      if (!ancestry.contains(link, twist.link)) continue;
      const auto in_world = [&](const Eigen::Vector4d& v) -> Vector3d {
        return scale * (pose.rotation(twist.link) * v.head<3>() + v[3] * pose.origin(twist.link));
      };
      const LinkAtDesign& at = geometry.links[twist.link];
      const InnerMotion& motion = at.inner[twist.inner_index];
      out.effects.push_back({columns[twist.coordinate], twist.link, false, true, Vector3d::Zero(),
                             in_world(motion.first), Vector3d::Zero(), scale * motion.first[3]});
      for (int l = twist.inner_index; at.bends && l < static_cast<int>(at.inner.size()); ++l) {
        const Twist& other =
            (&twist)[l - twist.inner_index];  // inner twists of a link are in a row
        out.seconds.push_back({columns[twist.coordinate], columns[other.coordinate],
                               in_world(motion.second_first(at.inner[l], twist.inner_index, l)),
                               &other == &twist});
      }
    } else if (ancestry.related(link, twist.link)) {
      const int lower = std::max(link, twist.link);  // children come after their parents
      const Scalars3 turn = scalars(twist.turn), shift = scalars(twist.shift);
      out.add(columns[twist.coordinate], twist, turn,
              scale * (cross(turn, scalars(pose.first_moment(lower))) +
                       geometry.mass_below[lower] * shift));
      store(shift, out.effects.back().shift);
    }
  }
  for (const SameLinkSecond& second : pose.same_link_seconds()) {
    const Twist &a = pose.twists()[second.a], &b = pose.twists()[second.b];
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
  for (const Twist& twist : pose.twists()) {
    if (twist.kind != Twist::Kind::inner || !geometry.links[twist.link].grows ||
        !ancestry.contains(link, twist.link))
      continue;
    const LinkAtDesign& at = geometry.links[twist.link];
    const InnerMotion& motion = at.inner[twist.inner_index];
    slopes.push_back({columns[twist.coordinate], scale * motion.first[3]});
    for (int l = twist.inner_index; l < static_cast<int>(at.inner.size()); ++l) {
      const Twist& other = (&twist)[l - twist.inner_index];
      seconds.push_back({columns[twist.coordinate], columns[other.coordinate],
                         scale * motion.second_first(at.inner[l], twist.inner_index, l)[3],
                         &other == &twist});
    }
  }
}

}  // namespace legwright
