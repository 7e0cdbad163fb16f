// SPDX-License-Identifier: Apache-2.0
#include "mjcf/leg_pose.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "optimizer/design/kinematics.hpp"

namespace legwright {

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

struct PosedRobot::Sight {
  Vector3d foot, reach;
  Eigen::Matrix3Xd jacobian;  // of the foot, by the leg's joints
};

PosedRobot::PosedRobot(const Morphology& morphology, const VectorXd& s)
    : morphology_(morphology), s_(s), geometry_(morphology, s) {}

PosedRobot::Sight PosedRobot::look(const VectorXd& pose, const LegJoints& leg) const {
  PoseKinematics at;
  at.compute(morphology_, geometry_, pose, PoseDetail::place);
  Sight out;
  const Foot& foot = morphology_.feet[leg.foot];
  out.foot = at.origin(foot.link) + at.rotation(foot.link) * geometry_.feet[leg.foot];
  const int first = leg.joints.empty() ? 0 : leg.joints.front() + 1;
  out.reach = out.foot - at.origin(first);
  out.jacobian.resize(3, static_cast<Eigen::Index>(leg.joints.size()));
  for (std::size_t k = 0; k < leg.joints.size(); ++k) {
    const int link = leg.joints[k] + 1;
    const Vector3d axis = at.rotation(link) * morphology_.links[link].joint.axis.at(s_);
    out.jacobian.col(static_cast<Eigen::Index>(k)) = axis.cross(out.foot - at.origin(link));
  }
  return out;
}

Vector3d PosedRobot::foot(const VectorXd& pose, int foot) const {
  return look(pose, {foot, {}}).foot;
}

Vector3d PosedRobot::reach(const VectorXd& pose, const LegJoints& leg) const {
  return look(pose, leg).reach;
}

/// One leg on its way to where it shall stand.
class PosedRobot::LegSolver {
 public:
  LegSolver(const PosedRobot& robot, VectorXd& pose, const LegJoints& leg, double height,
            const Vector2d& reach)
      : robot_(robot),
        pose_(pose),
        leg_(leg),
        height_(height),
        reach_(reach),
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
    sight_ = put(angles_);
  }

  bool run() {
    if (misses(sight_).norm() <= kExact) return true;
    approach();
    return reach_height();
  }

 private:
  Sight put(const VectorXd& angles) {
    for (Eigen::Index k = 0; k < count_; ++k) pose_[6 + leg_.joints[k]] = angles[k];
    return robot_.look(pose_, leg_);
  }

  Vector3d misses(const Sight& sight) const {
    return Vector3d(sight.reach.x() - reach_.x(), sight.reach.y() - reach_.y(),
                    kHeightWeight * (sight.foot.z() - height_)) /
           unit_;
  }

  double cost(const Sight& sight, const VectorXd& angles) const {
    return misses(sight).squaredNorm() + kStay * kStay * (angles - start_).squaredNorm();
  }

  /// Not held by the end of its range.
  bool is_free(Eigen::Index k, double step) const {
    return (step >= 0.0 || angles_[k] > lower_[k]) && (step <= 0.0 || angles_[k] < upper_[k]);
  }

  /// Levenberg-Marquardt within the ranges: all three directions at once, the height first.
  void approach() {
    double damping = 1e-6, last = 1.0;
    for (int step = 0; step < kMaxSteps && damping < 1e8; ++step) {
      Eigen::MatrixXd rows = sight_.jacobian / unit_;
      rows.row(2) *= kHeightWeight;
      VectorXd slope = rows.transpose() * misses(sight_) + kStay * kStay * (angles_ - start_);
      for (Eigen::Index k = 0; k < count_; ++k) {
        if (is_free(k, -slope[k])) continue;
        rows.col(k).setZero();
        slope[k] = 0.0;
      }
      Eigen::MatrixXd hessian = rows.transpose() * rows;
      hessian.diagonal().array() += kStay * kStay + damping;
      const VectorXd next =
          (angles_ - hessian.ldlt().solve(slope)).cwiseMax(lower_).cwiseMin(upper_);
      const Sight there = put(next);
      const double turned = (next - angles_).norm();
      // Costs tell apart no smaller steps; those go on while each is smaller than the last.
      const bool good =
          turned < kSmallTurn ? turned < last : cost(there, next) < cost(sight_, angles_);
      if (!good && turned < kSmallTurn) break;
      if (!good) {
        damping *= 10;
        continue;
      }
      angles_ = next;
      sight_ = there;
      last = turned;
      damping = std::max(1e-9, damping / 5);
    }
    sight_ = put(angles_);
  }

  /// The height alone, exactly, by the least turn.
  bool reach_height() {
    for (int step = 0; step < kMaxSteps; ++step) {
      const double miss = sight_.foot.z() - height_;
      if (std::abs(miss) <= kExact * unit_) return true;
      VectorXd slope = sight_.jacobian.row(2).transpose();
      for (Eigen::Index k = 0; k < count_; ++k)
        if (!is_free(k, -miss * slope[k])) slope[k] = 0.0;
      if (!(slope.norm() > 1e-6 * unit_)) return false;  // stretched out, or held by its ranges
      VectorXd turn = -miss / slope.squaredNorm() * slope;
      turn *= std::min(1.0, kLargestTurn / turn.norm());
      angles_ = (angles_ + turn).cwiseMax(lower_).cwiseMin(upper_);
      sight_ = put(angles_);
    }
    return std::abs(sight_.foot.z() - height_) <= 1e-11 * unit_;
  }

  const PosedRobot& robot_;
  VectorXd& pose_;
  const LegJoints& leg_;
  const double height_;
  const Vector2d reach_;
  const double unit_;
  const Eigen::Index count_;
  VectorXd start_, lower_, upper_, angles_;
  Sight sight_;
};

bool PosedRobot::solve(VectorXd& pose, const LegJoints& leg, double height,
                       const Vector2d& reach) const {
  return LegSolver(*this, pose, leg, height, reach).run();
}

}  // namespace legwright
