// SPDX-License-Identifier: Apache-2.0
#include "tools/task/stuck_feet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "optimizer/design/kinematics.hpp"

namespace legwright {
namespace {

constexpr double kLeastLift =
    0.02;                      // of the leg; a step of the default lifts it several times that
constexpr double kTurn = 1.2;  // from the home pose, within the range [rad]
constexpr int kAnglesTried = 12;

class Lifts {
 public:
  explicit Lifts(const RobotModel& robot)
      : body_(robot.morphology), geometry_(body_, robot.space.initial()) {
    home_.setZero(body_.pose_size());
    for (int j = 0; j < body_.joint_count(); ++j) home_[6 + j] = joint(j).nominal;
  }

  /// How far a joint raises or lowers a foot at most, the others as at home [m]. One that lowers it
  /// counts: with the others it may raise it, as of legs with round soles, whose centre is high up.
  double of_joint(int j, int foot) {
    const double from = std::max(joint(j).lower, home_[6 + j] - kTurn);
    const double to = std::min(joint(j).upper, home_[6 + j] + kTurn);
    const double ground = height(home_, foot);
    double lift = 0.0;
    for (int k = 0; k <= kAnglesTried; ++k) {
      Eigen::VectorXd q = home_;
      q[6 + j] = from + (to - from) * k / kAnglesTried;
      lift = std::max(lift, std::abs(height(q, foot) - ground));
    }
    return lift;
  }

 private:
  const Joint& joint(int j) const { return body_.links[static_cast<std::size_t>(j) + 1].joint; }
  double height(const Eigen::VectorXd& q, int foot) {
    pose_.compute(body_, geometry_, q, PoseDetail::place);
    return foot_place(body_, geometry_, pose_, foot).z();
  }

  const Morphology& body_;
  GeometryAtDesign geometry_;
  Eigen::VectorXd home_;
  PoseKinematics pose_;
};

}  // namespace

std::string stuck_foot_text(const RobotModel& robot) {
  const Morphology& body = robot.morphology;
  Lifts lifts(robot);
  for (int f = 0; f < body.foot_count(); ++f) {
    const Foot& foot = body.feet[static_cast<std::size_t>(f)];
    std::vector<std::string> joints;
    double lift = 0.0;
    for (const int link : body.chain_to(foot.link)) {
      joints.push_back("'" + body.links[static_cast<std::size_t>(link)].joint.name + "'");
      lift = std::max(lift, lifts.of_joint(link - 1, f));
    }
    if (lift >= kLeastLift * body.leg_length) continue;
    const bool one = joints.size() == 1;
    return fmt::format(
        "foot '{}' cannot be lifted: of its leg only {} {}, which {} not lift it; coupled joints "
        "are held in the home pose: remove what couples one that lifts the foot",
        foot.name, fmt::join(joints, ", "), one ? "moves" : "move", one ? "does" : "do");
  }
  return "";
}

}  // namespace legwright
