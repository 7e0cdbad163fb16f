// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/joint_torque.hpp"

#include <Eigen/Geometry>

#include "optimizer/design/pose_gradient.hpp"
#include "optimizer/design/rotation.hpp"
#include "optimizer/design/small_products.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

/// ∂(v × w) row by row: rows of `jacobian` are ∂v for one column of the block.
MatrixXd crossed(const MatrixXd& jacobian, const Vector3d& w) {
  return jacobian.lazyProduct(skew(w));  // (v × w)ᵀ = (−[w]× v)ᵀ = vᵀ [w]×
}

/// Adds factor · (M + Mᵀ), M = a · form · bᵀ, to a lower triangle.
void add_symmetric(double factor, const MatrixXd& a, const Eigen::Matrix3d& form, const MatrixXd& b,
                   MatrixXd& hessian) {
  const Eigen::Index columns = a.rows();
  for (Eigen::Index j = 0; j < columns; ++j) {
    // With rows aᵢ and bᵢ: M(i, j) = aᵢ · form bⱼ, and M(j, i) = bᵢ · formᵀ aⱼ.
    const Scalars3 right = factor * scalars(form * Vector3d(b.row(j))),
                   left = factor * scalars(form.transpose() * Vector3d(a.row(j)));
    double* out = hessian.col(j).data();
    for (Eigen::Index i = j; i < columns; ++i)
      out[i] += a(i, 0) * right.x + a(i, 1) * right.y + a(i, 2) * right.z +
                (b(i, 0) * left.x + b(i, 1) * left.y + b(i, 2) * left.z);
  }
}

struct Sums {
  Scalars3 rate, lever;  // K, N
};

Scalars3 contact_point(const Morphology& morphology, const GeometryAtDesign& geometry,
                       const PoseKinematics& pose, int foot) {
  const int link = morphology.feet[foot].link;
  const Scalars3 centre =
      scalars(pose.origin(link)) + product(pose.rotation(link), scalars(geometry.feet[foot]));
  return {centre.x, centre.y, centre.z - morphology.feet[foot].radius};
}

Sums sums(const Morphology& morphology, const GeometryAtDesign& geometry, const PoseTriple& poses,
          int link, double time_step, const std::vector<FootForce>& forces) {
  const double per_time = 1.0 / (time_step * time_step);
  const Scalars3 moment = scalars(poses.at->first_moment(link)), up = scalars(poses.up);
  Sums out;
  out.rate = per_time * (scalars(poses.before->first_moment(link)) - 2.0 * moment +
                         scalars(poses.after->first_moment(link))) +
             kGravity * geometry.mass_below[link] * up;
  out.lever = per_time * (poses.to_after->swept_scalars(link) - poses.to_at->swept_scalars(link)) +
              kGravity * cross(moment, up);
  for (const FootForce& each : forces) {
    const Scalars3 force = scalars(each.force);
    out.rate = out.rate - force;
    out.lever = out.lever - cross(contact_point(morphology, geometry, *poses.at, each.foot), force);
  }
  out.lever = out.lever - cross(scalars(poses.at->origin(link)), out.rate);
  return out;
}

}  // namespace

double JointTorque::value(const Morphology& morphology, const GeometryAtDesign& geometry,
                          const PoseTriple& poses, int link, double time_step,
                          const std::vector<FootForce>& forces) {
  const Sums at = sums(morphology, geometry, poses, link, time_step, forces);
  return dot(product(poses.at->before(link), scalars(geometry.links[link].axis.axis)), at.lever);
}

void JointTorque::compute(const Morphology& morphology, const GeometryAtDesign& geometry,
                          const Ancestry& ancestry, const PoseTriple& poses, int link,
                          double time_step, const std::vector<FootForce>& forces,
                          const Slots& slots, int column_count) {
  const Sums at = sums(morphology, geometry, poses, link, time_step, forces);
  store(at.rate, rate_);
  store(at.lever, lever_);
  time_step_ = time_step;
  up_ = poses.up;
  feet_.resize(forces.size());
  for (std::size_t k = 0; k < forces.size(); ++k) {
    feet_[k].foot = forces[k].foot;
    store(contact_point(morphology, geometry, *poses.at, forces[k].foot), feet_[k].contact);
    feet_[k].force = forces[k].force;
    feet_[k].column = slots.force[k];
    feet_[k].jacobian.setZero(column_count, 3);
  }
  for (MatrixXd* each :
       {&axis_jacobian_, &anchor_jacobian_, &moment_jacobian_, &rate_jacobian_, &lever_jacobian_})
    each->setZero(column_count, 3);
  if (poses.at->with_design())
    derive(morphology, geometry, ancestry, poses, link, slots);
  else
    derive_by_motion(morphology, geometry, ancestry, poses, link, slots);
  sum_parts();
}

void JointTorque::derive_by_motion(const Morphology& morphology, const GeometryAtDesign& geometry,
                                   const Ancestry& ancestry, const PoseTriple& poses, int link,
                                   const Slots& slots) {
  const double per_time = 1.0 / (time_step_ * time_step_);
  const int parent = parent_of(morphology, link);  // its own joint moves neither axis nor anchor
  axis_at_ = poses.at->before(link) * geometry.links[link].axis.axis;
  anchor_at_ = poses.at->origin(link);
  add_direction_jacobian(morphology, *poses.at, parent, axis_at_, *slots.at, axis_jacobian_);
  add_point_jacobian(morphology, *poses.at, parent, anchor_at_, *slots.at, anchor_jacobian_);
  const auto add_moment = [&](const PoseKinematics& pose, double scale, const Columns& columns,
                              MatrixXd& out) {
    add_first_moment_jacobian(geometry, ancestry, pose, link, scale, columns, out);
  };
  add_moment(*poses.at, 1.0, *slots.at, moment_jacobian_);
  add_moment(*poses.before, per_time, *slots.before, rate_jacobian_);
  add_moment(*poses.after, per_time, *slots.after, rate_jacobian_);
  rate_jacobian_ -= 2.0 * per_time * moment_jacobian_;
  add_swept_momentum_jacobian(ancestry, *poses.to_at, link, *poses.before, *poses.at, *slots.before,
                              *slots.at, lever_jacobian_);
  lever_jacobian_ *= -1.0;
  add_swept_momentum_jacobian(ancestry, *poses.to_after, link, *poses.at, *poses.after, *slots.at,
                              *slots.after, lever_jacobian_);
  lever_jacobian_ *= per_time;
  for (Carried& foot : feet_) {
    store(contact_point(morphology, geometry, *poses.at, foot.foot), foot.centre.value);
    foot.centre.value[2] += morphology.feet[foot.foot].radius;
    add_point_jacobian(morphology, *poses.at, morphology.feet[foot.foot].link, foot.centre.value,
                       *slots.at, foot.jacobian);
  }
}

void JointTorque::derive(const Morphology& morphology, const GeometryAtDesign& geometry,
                         const Ancestry& ancestry, const PoseTriple& poses, int link,
                         const Slots& slots) {
  const double per_time = 1.0 / (time_step_ * time_step_);
  axis_from_pose(morphology, geometry, ancestry, *poses.at, link, *slots.at, axis_);
  anchor_from_pose(ancestry, *poses.at, link, *slots.at, anchor_);
  const auto moment = [&](const PoseKinematics& pose, const Columns& columns,
                          PointDerivatives& out) {
    first_moment_from_pose(geometry, ancestry, pose, link, 1.0, columns, out);
  };
  moment(*poses.before, *slots.before, moment_before_);
  moment(*poses.at, *slots.at, moment_);
  moment(*poses.after, *slots.after, moment_after_);
  swept_before_.compute_swept_momentum(geometry, ancestry, link, *poses.to_at, *poses.before,
                                       *poses.at, *slots.before, *slots.at);
  swept_.compute_swept_momentum(geometry, ancestry, link, *poses.to_after, *poses.at, *poses.after,
                                *slots.at, *slots.after);
  mass_from_pose(geometry, ancestry, *poses.at, link, kGravity, *slots.at, mass_slopes_,
                 mass_seconds_);
  axis_at_ = axis_.value;
  anchor_at_ = anchor_.value;
  axis_.add_jacobian(axis_jacobian_);
  anchor_.add_jacobian(anchor_jacobian_);
  moment_.add_jacobian(moment_jacobian_);
  moment_before_.add_jacobian(rate_jacobian_);
  moment_after_.add_jacobian(rate_jacobian_);
  rate_jacobian_ = per_time * (rate_jacobian_ - 2.0 * moment_jacobian_);
  for (const PointDerivatives::Growth& growth : mass_slopes_)
    rate_jacobian_.row(growth.column) += growth.slope * up_.transpose();
  swept_before_.add_jacobian(lever_jacobian_);
  lever_jacobian_ *= -1.0;
  swept_.add_jacobian(lever_jacobian_);
  lever_jacobian_ *= per_time;
  for (Carried& foot : feet_) {
    foot_from_pose(morphology, geometry, ancestry, *poses.at, foot.foot, *slots.at, foot.centre);
    foot.centre.add_jacobian(foot.jacobian);
  }
}

void JointTorque::sum_parts() {
  lever_jacobian_ += kGravity * crossed(moment_jacobian_, up_);
  for (const Carried& foot : feet_) {
    rate_jacobian_.middleRows<3>(foot.column) -= Eigen::Matrix3d::Identity();
    lever_jacobian_ -= crossed(foot.jacobian, foot.force);
    lever_jacobian_.middleRows<3>(foot.column) -= skew(foot.contact).transpose();
  }
  lever_jacobian_ -= crossed(anchor_jacobian_, rate_);
  lever_jacobian_ -= rate_jacobian_.lazyProduct(skew(anchor_at_).transpose());
}

void JointTorque::add_jacobian(MatrixXd& jacobian) const {
  jacobian.col(0) += axis_jacobian_ * lever_ + lever_jacobian_ * axis_at_;
}

void JointTorque::add_products(double multiplier, MatrixXd& hessian) const {
  add_symmetric(multiplier, axis_jacobian_, Eigen::Matrix3d::Identity(), lever_jacobian_, hessian);
  const Eigen::Matrix3d form = -skew(multiplier * axis_at_);  // A · (v × w) = vᵀ form w
  add_symmetric(-1.0, anchor_jacobian_, form, rate_jacobian_, hessian);
  for (const Carried& foot : feet_) {
    MatrixXd selects = MatrixXd::Zero(hessian.rows(), 3);
    selects.middleRows<3>(foot.column).setIdentity();
    add_symmetric(-1.0, foot.jacobian, form, selects, hessian);
  }
}

/// A · ∂²N with A held: the swept momenta, the moments by gravity's lever and by K, the anchor, the
/// feet.
struct JointTorque::Factors {
  Vector3d axis, swept, of_rate, moment_beside, moment, anchor;
};

JointTorque::Factors JointTorque::factors(double multiplier) const {
  const double per_time = 1.0 / (time_step_ * time_step_);
  const Vector3d A = multiplier * axis_at_;
  const Vector3d of_rate = anchor_at_.cross(A);  // A · (−o × ∂K) = ∂K · (o × A)
  return {multiplier * lever_,
          per_time * A,
          of_rate,
          per_time * of_rate,
          -2.0 * per_time * of_rate + kGravity * up_.cross(A),
          A.cross(rate_)};
}

void JointTorque::add_loads(const Morphology& morphology, const GeometryAtDesign& geometry,
                            const Ancestry& ancestry, const PoseTriple& poses, int link,
                            double multiplier, const Loads& loads) const {
  const Factors by = factors(multiplier);
  const int parent = parent_of(morphology, link);
  loads.at.add_direction(morphology, parent, scalars(axis_at_), scalars(by.axis));
  loads.at.add_point(morphology, parent, scalars(anchor_at_), scalars(by.anchor));
  loads.to_at.add_swept_momentum(geometry, ancestry, link, *poses.to_at, *poses.before, *poses.at,
                                 -scalars(by.swept), loads.before, loads.at);
  loads.to_after.add_swept_momentum(geometry, ancestry, link, *poses.to_after, *poses.at,
                                    *poses.after, scalars(by.swept), loads.at, loads.after);
  const auto add_moment = [&](const PoseKinematics& pose, const Vector3d& factor, PoseLoads& to) {
    to.add_first_moment(geometry, ancestry, pose, link, scalars(factor));
  };
  add_moment(*poses.before, by.moment_beside, loads.before);
  add_moment(*poses.at, by.moment, loads.at);
  add_moment(*poses.after, by.moment_beside, loads.after);
  const Scalars3 A = multiplier * scalars(axis_at_);
  for (const Carried& foot : feet_)
    loads.at.add_point(morphology, morphology.feet[foot.foot].link, scalars(foot.centre.value),
                       cross(A, scalars(foot.force)));
}

void JointTorque::add_curvature(const Ancestry& ancestry, double multiplier,
                                MatrixXd& hessian) const {
  const Factors by = factors(multiplier);
  axis_.add_curvature(ancestry, by.axis, hessian);
  swept_.add_curvature(ancestry, by.swept, hessian);
  swept_before_.add_curvature(ancestry, -by.swept, hessian);
  moment_before_.add_curvature(ancestry, by.moment_beside, hessian);
  moment_after_.add_curvature(ancestry, by.moment_beside, hessian);
  moment_.add_curvature(ancestry, by.moment, hessian);
  const double up_rate = by.of_rate.dot(up_);
  for (const PointDerivatives::GrowthSecond& second : mass_seconds_) {
    if (second.same)
      hessian(second.a, second.a) += up_rate * second.second;
    else
      add_pair(hessian, second.a, second.b, up_rate * second.second);
  }
  anchor_.add_curvature(ancestry, by.anchor, hessian);
  const Vector3d A = multiplier * axis_at_;
  for (const Carried& foot : feet_)
    foot.centre.add_curvature(ancestry, A.cross(foot.force), hessian);
  add_products(multiplier, hessian);
}

}  // namespace legwright
