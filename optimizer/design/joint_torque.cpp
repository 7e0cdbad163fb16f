// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/joint_torque.hpp"

#include <Eigen/Geometry>

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
  feet_.resize(forces.size());
  for (std::size_t k = 0; k < forces.size(); ++k) {
    foot_from_pose(morphology, geometry, ancestry, *poses.at, forces[k].foot, *slots.at,
                   feet_[k].centre);
    store(contact_point(morphology, geometry, *poses.at, forces[k].foot), feet_[k].contact);
    feet_[k].force = forces[k].force;
    feet_[k].column = slots.force[k];
  }
  sum_parts(column_count);
}

void JointTorque::sum_parts(int column_count) {
  const double per_time = 1.0 / (time_step_ * time_step_);
  const auto jacobian_of = [&](const auto& part) {
    MatrixXd out = MatrixXd::Zero(column_count, 3);
    part.add_jacobian(out);
    return out;
  };
  axis_jacobian_ = jacobian_of(axis_);
  anchor_jacobian_ = jacobian_of(anchor_);
  const MatrixXd moment = jacobian_of(moment_);
  rate_jacobian_ =
      per_time * (jacobian_of(moment_before_) - 2.0 * moment + jacobian_of(moment_after_));
  for (const PointDerivatives::Growth& growth : mass_slopes_)
    rate_jacobian_.row(growth.column) += growth.slope * up_.transpose();
  lever_jacobian_ = per_time * (jacobian_of(swept_) - jacobian_of(swept_before_)) +
                    kGravity * crossed(moment, up_);
  for (Carried& foot : feet_) {
    foot.jacobian = jacobian_of(foot.centre);
    rate_jacobian_.middleRows<3>(foot.column) -= Eigen::Matrix3d::Identity();
    lever_jacobian_ -= crossed(foot.jacobian, foot.force);
    lever_jacobian_.middleRows<3>(foot.column) -= skew(foot.contact).transpose();
  }
  lever_jacobian_ -= crossed(anchor_jacobian_, rate_);
  lever_jacobian_ -= rate_jacobian_.lazyProduct(skew(anchor_.value).transpose());
}

void JointTorque::add_jacobian(MatrixXd& jacobian) const {
  jacobian.col(0) += axis_jacobian_ * lever_ + lever_jacobian_ * axis_.value;
}

void JointTorque::add_curvature(const Ancestry& ancestry, double multiplier,
                                MatrixXd& hessian) const {
  const double per_time = 1.0 / (time_step_ * time_step_);
  const Vector3d A = multiplier * axis_.value, o = anchor_.value;
  axis_.add_curvature(ancestry, multiplier * lever_, hessian);
  add_symmetric(multiplier, axis_jacobian_, Eigen::Matrix3d::Identity(), lever_jacobian_, hessian);
  // A · ∂²N with A held: the swept momenta, the moments by gravity's lever and by K, the anchor,
  // the feet.
  swept_.add_curvature(ancestry, per_time * A, hessian);
  swept_before_.add_curvature(ancestry, -per_time * A, hessian);
  const Vector3d of_rate = o.cross(A);  // A · (−o × ∂K) = ∂K · (o × A)
  moment_before_.add_curvature(ancestry, per_time * of_rate, hessian);
  moment_after_.add_curvature(ancestry, per_time * of_rate, hessian);
  moment_.add_curvature(ancestry, -2.0 * per_time * of_rate + kGravity * up_.cross(A), hessian);
  const double up_rate = of_rate.dot(up_);
  for (const PointDerivatives::GrowthSecond& second : mass_seconds_) {
    if (second.same)
      hessian(second.a, second.a) += up_rate * second.second;
    else
      add_pair(hessian, second.a, second.b, up_rate * second.second);
  }
  anchor_.add_curvature(ancestry, A.cross(rate_), hessian);
  const Eigen::Matrix3d form = -skew(A);  // A · (v × w) = vᵀ form w
  add_symmetric(-1.0, anchor_jacobian_, form, rate_jacobian_, hessian);
  for (const Carried& foot : feet_) {
    foot.centre.add_curvature(ancestry, A.cross(foot.force), hessian);
    MatrixXd selects = MatrixXd::Zero(hessian.rows(), 3);
    selects.middleRows<3>(foot.column).setIdentity();
    add_symmetric(-1.0, foot.jacobian, form, selects, hessian);
  }
}

}  // namespace legwright
