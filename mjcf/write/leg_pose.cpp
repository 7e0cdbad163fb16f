// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/leg_pose.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "optimizer/design/kinematics.hpp"

namespace legwright {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr int kMaxSteps = 100;
constexpr double kHeightWeight = 10.0;  // of the height against the place from above
constexpr double kStay = 0.03;          // leg lengths of place that a radian is worth
constexpr double kExact = 1e-13;        // leg lengths: rounding of the sums
constexpr double kLargestTurn = 0.3;    // [rad] in one step
constexpr double kSmallTurn = 1e-6;     // [rad] whose gain is lost in the rounding of costs

}  // namespace

std::vector<LegJoints> legs_of(const Morphology& morphology) {
  std::vector<int> users(morphology.links.size(), 0);
  for (const Foot& foot : morphology.feet)
    for (const int link : morphology.chain_to(foot.link)) ++users[link];
  std::vector<LegJoints> legs;
  for (int f = 0; f < morphology.foot_count(); ++f) {
    LegJoints leg;
    leg.foot = f;
    for (const int link : morphology.chain_to(morphology.feet[f].link))
      if (users[link] == 1) leg.joints.push_back(link - 1);
    legs.push_back(std::move(leg));
  }
  return legs;
}

/// A leg in a pose.
struct PosedRobot::LegState {
  Vector3d foot, reach;
  Eigen::Matrix3Xd jacobian;  // of the foot, by the leg's joints
  Eigen::Matrix3Xd axes;      // of the leg's joints, world
  std::optional<Sole> sole;   // world
};

PosedRobot::PosedRobot(const Morphology& morphology, const VectorXd& s)
    : morphology_(morphology), s_(s), geometry_(morphology, s) {}

PosedRobot::LegState PosedRobot::evaluate(const VectorXd& pose, const LegJoints& leg) const {
  PoseKinematics at;
  at.compute(morphology_, geometry_, pose, PoseDetail::place);
  LegState out;
  const Foot& foot = morphology_.feet[leg.foot];
  out.foot = foot_place(morphology_, geometry_, at, leg.foot);
  const int first = leg.joints.empty() ? 0 : leg.joints.front() + 1;
  out.reach = out.foot - at.origin(first);
  if (foot.sole)
    out.sole =
        Sole{at.rotation(foot.link) * foot.sole->ahead, at.rotation(foot.link) * foot.sole->beside};
  out.jacobian.resize(3, static_cast<Eigen::Index>(leg.joints.size()));
  out.axes.resizeLike(out.jacobian);
  for (std::size_t k = 0; k < leg.joints.size(); ++k) {
    const int link = leg.joints[k] + 1;
    const Vector3d axis = at.rotation(link) * morphology_.links[link].joint.axis.at(s_);
    out.axes.col(static_cast<Eigen::Index>(k)) = axis;
    out.jacobian.col(static_cast<Eigen::Index>(k)) = axis.cross(out.foot - at.origin(link));
  }
  return out;
}

Vector3d PosedRobot::foot(const VectorXd& pose, int foot) const {
  return evaluate(pose, {foot, {}}).foot;
}

Vector3d PosedRobot::reach(const VectorXd& pose, const LegJoints& leg) const {
  return evaluate(pose, leg).reach;
}

std::optional<Sole> PosedRobot::sole(const VectorXd& pose, int foot) const {
  return evaluate(pose, {foot, {}}).sole;
}

/// One leg on its way to where it shall stand.
class PosedRobot::LegSolver {
 public:
  LegSolver(const PosedRobot& robot, VectorXd& pose, const LegJoints& leg, const LegTarget& target)
      : robot_(robot),
        pose_(pose),
        leg_(leg),
        target_(target),
        unit_(robot.morphology_.leg_length),
        count_(static_cast<Eigen::Index>(leg.joints.size())),
        start_(count_),
        lower_(count_),
        upper_(count_) {
    for (Eigen::Index k = 0; k < count_; ++k) {
      const Joint& joint = robot.morphology_.links[leg.joints[k] + 1].joint;
      start_[k] = pose[6 + leg.joints[k]];
      lower_[k] = std::min(joint.lower, start_[k]);  // a keyframe may lie outside of a range
      upper_[k] = std::max(joint.upper, start_[k]);
    }
    angles_ = start_;
    state_ = put(angles_);
  }

  bool run() {
    if (misses(state_).norm() <= kExact) return true;
    approach();
    if (target_.sole) lay_down();
    return reach_height();
  }

 private:
  LegState put(const VectorXd& angles) {
    for (Eigen::Index k = 0; k < count_; ++k) pose_[6 + leg_.joints[k]] = angles[k];
    return robot_.evaluate(pose_, leg_);
  }

  /// How much each direction of a miss counts: of a place the height first, of a sole's directions
  /// that they are level.
  static Vector3d weight() { return {1.0, 1.0, kHeightWeight}; }

  VectorXd misses(const LegState& state) const {
    VectorXd out(target_.sole ? 9 : 3);
    out.head<3>() = weight().cwiseProduct(Vector3d(state.reach.x() - target_.reach.x(),
                                                   state.reach.y() - target_.reach.y(),
                                                   state.foot.z() - target_.height)) /
                    unit_;
    if (target_.sole) {
      out.segment<3>(3) = weight().cwiseProduct(state.sole->ahead - target_.sole->ahead);
      out.segment<3>(6) = weight().cwiseProduct(state.sole->beside - target_.sole->beside);
    }
    return out;
  }

  /// Slopes of the misses.
  MatrixXd slopes(const LegState& state) const {
    MatrixXd rows(target_.sole ? 9 : 3, count_);
    rows.topRows<3>() = state.jacobian / unit_;
    rows.row(2) *= kHeightWeight;
    for (Eigen::Index k = 0; target_.sole && k < count_; ++k) {
      const Vector3d axis = state.axes.col(k);
      rows.col(k).segment<3>(3) = weight().cwiseProduct(axis.cross(state.sole->ahead));
      rows.col(k).segment<3>(6) = weight().cwiseProduct(axis.cross(state.sole->beside));
    }
    return rows;
  }

  double cost(const LegState& state, const VectorXd& angles) const {
    return misses(state).squaredNorm() + kStay * kStay * (angles - start_).squaredNorm();
  }

  /// Not held by the end of its range.
  bool is_free(Eigen::Index k, double step) const {
    return (step >= 0.0 || angles_[k] > lower_[k]) && (step <= 0.0 || angles_[k] < upper_[k]);
  }

  /// Levenberg-Marquardt within the ranges: all three directions at once, the height first.
  void approach() {
    double damping = 1e-6, last = 1.0;
    for (int step = 0; step < kMaxSteps && damping < 1e8; ++step) {
      MatrixXd rows = slopes(state_);
      VectorXd slope = rows.transpose() * misses(state_) + kStay * kStay * (angles_ - start_);
      for (Eigen::Index k = 0; k < count_; ++k) {
        if (is_free(k, -slope[k])) continue;
        rows.col(k).setZero();
        slope[k] = 0.0;
      }
      MatrixXd hessian = rows.transpose() * rows;
      hessian.diagonal().array() += kStay * kStay + damping;
      const VectorXd next =
          (angles_ - hessian.ldlt().solve(slope)).cwiseMax(lower_).cwiseMin(upper_);
      const LegState there = put(next);
      const double step_norm = (next - angles_).norm();
      // Costs tell apart no smaller steps; those go on while each is smaller than the last.
      const bool good =
          step_norm < kSmallTurn ? step_norm < last : cost(there, next) < cost(state_, angles_);
      if (!good && step_norm < kSmallTurn) break;
      if (!good) {
        damping *= 10;
        continue;
      }
      angles_ = next;
      state_ = there;
      last = step_norm;
      damping = std::max(1e-9, damping / 5);
    }
    state_ = put(angles_);
  }

  /// Height and tilt of the sole, exactly, by the least turns; where they are out of reach all
  /// stays as it was.
  void lay_down() {
    const VectorXd before = angles_;
    for (int step = 0; step < kMaxSteps; ++step) {
      const VectorXd all = misses(state_);
      const Vector3d miss(all[2], all[5], all[8]);
      if (miss.norm() <= kHeightWeight * kExact) return;
      const MatrixXd rows = slopes(state_);
      MatrixXd level(3, count_);
      level << rows.row(2), rows.row(5), rows.row(8);
      VectorXd turn = -level.completeOrthogonalDecomposition().solve(miss);
      bool held = false;
      for (Eigen::Index k = 0; k < count_; ++k) {
        if (is_free(k, turn[k])) continue;
        held = true;
        level.col(k).setZero();
      }
      if (held) turn = -level.completeOrthogonalDecomposition().solve(miss);
      turn *= std::min(1.0, kLargestTurn / std::max(turn.norm(), kLargestTurn));
      angles_ = (angles_ + turn).cwiseMax(lower_).cwiseMin(upper_);
      state_ = put(angles_);
    }
    const VectorXd left = misses(state_);
    if (std::hypot(left[2], left[5], left[8]) <= 1e-9) return;
    angles_ = before;
    state_ = put(angles_);
  }

  /// The height alone, exactly, by the least turn.
  bool reach_height() {
    for (int step = 0; step < kMaxSteps; ++step) {
      const double miss = state_.foot.z() - target_.height;
      if (std::abs(miss) <= kExact * unit_) return true;
      VectorXd slope = state_.jacobian.row(2).transpose();
      for (Eigen::Index k = 0; k < count_; ++k)
        if (!is_free(k, -miss * slope[k])) slope[k] = 0.0;
      if (!(slope.norm() > 1e-6 * unit_)) return false;  // stretched out, or held by its ranges
      VectorXd turn = -miss / slope.squaredNorm() * slope;
      turn *= std::min(1.0, kLargestTurn / turn.norm());
      angles_ = (angles_ + turn).cwiseMax(lower_).cwiseMin(upper_);
      state_ = put(angles_);
    }
    return std::abs(state_.foot.z() - target_.height) <= 1e-11 * unit_;
  }

  const PosedRobot& robot_;
  VectorXd& pose_;
  const LegJoints& leg_;
  const LegTarget& target_;
  const double unit_;
  const Eigen::Index count_;
  VectorXd start_, lower_, upper_, angles_;
  LegState state_;
};

bool PosedRobot::solve(VectorXd& pose, const LegJoints& leg, const LegTarget& target) const {
  return LegSolver(*this, pose, leg, target).run();
}

}  // namespace legwright
