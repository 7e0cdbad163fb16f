// SPDX-License-Identifier: Apache-2.0
// The first guess of a robot on flat feet: soles are level and look where the robot goes, knot by
// knot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "optimizer/design/kinematics.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "optimizer/motion/motion.hpp"
#include "optimizer/motion/pendulum.hpp"
#include "optimizer/objective/objective.hpp"
#include "tests/support/flat_biped.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct Askew {
  double tilt = 0.0, turn = 0.0;  // most of any sole at any knot [rad]
};

/// @param toes_out at home; the guess keeps it. @param flat whether the planner knows of the soles
Askew askew_soles(double toes_out, double turn_rate, bool flat) {
  test::Puppy biped = test::make_flat_biped(toes_out);
  if (!flat)
    for (Foot& foot : biped.morphology.feet) foot.sole.reset();
  Task task = test::make_flat_walk();
  task.turn_rate = turn_rate;
  const VectorXd s = biped.space.initial();
  const StyleTargets style = style_targets(biped.morphology, s, task);
  task.com_path = pendulum_path(task, style.footprint, style.com_height);
  const Objective objective(biped.morphology, biped.space, task);
  const VectorXd m = initial_guess(objective, s);
  const MotionView motion(objective.layout(), m);
  const GeometryAtDesign geometry(biped.morphology, s);
  PoseKinematics pose;
  Askew out;
  for (int i = 0; i <= task.gait.knot_count(); ++i) {
    pose.compute(biped.morphology, geometry, motion.pose(i), PoseDetail::place);
    const double heading = objective.path().heading(i * task.gait.time_step());
    for (int j = 0; j < 2; ++j) {
      const Eigen::Matrix3d turn = pose.rotation(biped.morphology.feet[j].link);
      const Vector3d ahead = turn.col(0);
      const double splay = j == 0 ? toes_out : -toes_out;
      out.tilt = std::max(out.tilt, std::acos(std::min(1.0, turn(2, 2))));
      out.turn = std::max(
          out.turn, std::abs(std::remainder(std::atan2(ahead.y(), ahead.x()) - heading - splay,
                                            2.0 * std::numbers::pi)));
    }
  }
  return out;
}

TEST(InitialGuessOfFlatFeet, SolesAreLevelAndLookAhead) {
  for (const double toes_out : {0.0, 0.2})
    for (const double turn_rate : {0.0, 0.3}) {
      const Askew askew = askew_soles(toes_out, turn_rate, true);
      EXPECT_LT(askew.tilt, 0.02) << toes_out << " " << turn_rate;
      EXPECT_LT(askew.turn, 0.02) << toes_out << " " << turn_rate;
    }
}

TEST(InitialGuessOfFlatFeet, PointsOfTheSamePlaceWouldTiltThem) {
  EXPECT_GT(askew_soles(0.0, 0.0, false).tilt, 0.05);
}

}  // namespace
}  // namespace legwright
