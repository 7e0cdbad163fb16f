// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/whole_body_ik.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace legwright {
namespace {

constexpr double kLeastDamping = 1e-4;  // of a step
constexpr double kLargestStep = 0.5;    // [rad, leg lengths]
constexpr double kEnough = 1e-3;        // step below which it is the last

}  // namespace

WholeBodyIk::WholeBodyIk(const Morphology& morphology, const GeometryAtDesign& geometry,
                         const WholeBodyIkWeights& weights)
    : morphology_(morphology),
      geometry_(geometry),
      weights_(weights),
      ancestry_(morphology),
      nominal_(morphology.nominal_joints()) {
  columns_.resize(morphology.pose_size());
  std::iota(columns_.begin(), columns_.end(), 0);
  Eigen::VectorXd home = Eigen::VectorXd::Zero(morphology.pose_size());
  home.tail(morphology.joint_count()) = nominal_;
  pose_.compute(morphology, geometry, home, PoseDetail::place);
  for (const Foot& foot : morphology.feet) {
    const Eigen::Vector3d ahead =
        foot.sole ? Eigen::Vector3d(pose_.rotation(foot.link) * foot.sole->ahead)
                  : Eigen::Vector3d::UnitX();
    splay_.push_back(std::atan2(ahead.y(), ahead.x()));
  }
}

template <class Visit>
void WholeBodyIk::for_each_sole_direction(double heading, const Visit& visit) const {
  for (std::size_t j = 0; j < morphology_.feet.size(); ++j) {
    const Foot& foot = morphology_.feet[j];
    if (!foot.sole) continue;
    const double angle = heading + splay_[j];
    const Eigen::Vector3d ahead(std::cos(angle), std::sin(angle), 0.0);
    visit(foot.link, foot.sole->ahead, ahead);
    visit(foot.link, foot.sole->beside, Eigen::Vector3d::UnitZ().cross(ahead).eval());
  }
}

double WholeBodyIk::misfit(const Places& wanted, const Eigen::VectorXd& q) {
  const double length = morphology_.leg_length;
  pose_.compute(morphology_, geometry_, q, PoseDetail::place);
  const Eigen::Vector3d com = pose_.first_moment(0) / geometry_.total_mass;
  const auto miss = [](const Eigen::Vector3d& d, const Eigen::Vector3d& weight) {
    return d.cwiseAbs2().dot(weight);
  };
  double sum = miss(com - wanted.com, weights_.com);
  for (int j = 0; j < morphology_.foot_count(); ++j)
    sum += miss(foot_place(morphology_, geometry_, pose_, j) - wanted.feet[j], weights_.foot);
  double tilt = 0.0;
  for_each_sole_direction(wanted.heading, [&](int link, const auto& own, const auto& direction) {
    tilt += weights_.sole * (pose_.rotation(link) * own - direction).squaredNorm();
  });
  return sum / (length * length) + tilt +
         weights_.pose * (q.tail(morphology_.joint_count()) - nominal_).squaredNorm();
}

void WholeBodyIk::add_point(const PointDerivatives& point, const Eigen::Vector3d& wanted,
                            const Eigen::Vector3d& weight) {
  jacobian_.setZero();
  point.add_jacobian(jacobian_);
  jacobian_.middleRows<3>(3).setZero();  // the trunk's orientation is given
  normal_ += jacobian_ * weight.asDiagonal() * jacobian_.transpose();
  slope_ += jacobian_ * weight.cwiseProduct(point.value - wanted);
}

void WholeBodyIk::linearise(const Places& wanted, const Eigen::VectorXd& q) {
  const int joints = morphology_.joint_count(), count = morphology_.pose_size();
  const double scale = 1.0 / (morphology_.leg_length * morphology_.leg_length);
  jacobian_.resize(count, 3);
  normal_.setZero(count, count);
  slope_.setZero(count);
  pose_.compute(morphology_, geometry_, q, PoseDetail::motion);
  com_from_pose(geometry_, ancestry_, pose_, columns_, point_);
  add_point(point_, wanted.com, scale * weights_.com);
  for (int j = 0; j < morphology_.foot_count(); ++j) {
    foot_from_pose(morphology_, geometry_, ancestry_, pose_, j, columns_, point_);
    add_point(point_, wanted.feet[j], scale * weights_.foot);
  }
  for_each_sole_direction(wanted.heading, [&](int link, const auto& own, const auto& direction) {
    direction_from_pose(ancestry_, pose_, link, own, columns_, point_);
    add_point(point_, direction, Eigen::Vector3d::Constant(weights_.sole));
  });
  normal_.diagonal().tail(joints).array() += weights_.pose;
  slope_.tail(joints) += weights_.pose * (q.tail(joints) - nominal_);
}

Eigen::VectorXd WholeBodyIk::stepped(const Eigen::VectorXd& q, double damping) const {
  const int joints = morphology_.joint_count();
  const double length = morphology_.leg_length;
  Eigen::VectorXd units = Eigen::VectorXd::Ones(slope_.size());
  units.head<3>().setConstant(length);
  Eigen::MatrixXd damped = normal_;
  damped.diagonal() += damping * units.cwiseAbs2().cwiseInverse();
  Eigen::VectorXd step = -damped.llt().solve(slope_);
  const double size = step.cwiseQuotient(units).lpNorm<Eigen::Infinity>();
  if (size > kLargestStep) step *= kLargestStep / size;
  Eigen::VectorXd next = q;
  next.head<3>() += step.head<3>();
  for (int a = 0; a < joints; ++a) {
    const Joint& joint = morphology_.links[a + 1].joint;
    next[6 + a] = std::clamp(q[6 + a] + step[6 + a], joint.lower, joint.upper);
  }
  return next;
}

WholeBodyIk::Places WholeBodyIk::places_at(const Eigen::VectorXd& q) {
  pose_.compute(morphology_, geometry_, q, PoseDetail::place);
  Places places{pose_.first_moment(0) / geometry_.total_mass, {}};
  for (int j = 0; j < morphology_.foot_count(); ++j)
    places.feet.push_back(foot_place(morphology_, geometry_, pose_, j));
  return places;
}

void WholeBodyIk::improve(const Places& wanted, int steps, Eigen::VectorXd& q) {
  double value = misfit(wanted, q), damping = kLeastDamping;
  for (int k = 0; k < steps; ++k) {
    linearise(wanted, q);
    const Eigen::VectorXd next = stepped(q, damping);
    const double there = misfit(wanted, next);
    if (!(there < value)) {
      damping *= 10.0;
      continue;
    }
    const double moved = (next - q).lpNorm<Eigen::Infinity>();
    q = next;
    value = there;
    damping = std::max(kLeastDamping, 0.1 * damping);
    if (moved < kEnough) return;
  }
}

}  // namespace legwright
