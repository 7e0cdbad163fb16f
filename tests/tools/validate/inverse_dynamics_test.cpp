// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/inverse_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mjcf/scene/emit_scene.hpp"
#include "plugin/spline.hpp"
#include "tests/tools/simulate/standing_puppy.hpp"
#include "tools/simulate/plan.hpp"
#include "tools/simulate/plan_dynamics.hpp"

namespace legwright {
namespace {

Scene standing_scene(const StandingPuppy& puppy) {
  const PlayablePlan plan =
      make_playable(puppy.robot.morphology, puppy.robot.xml, puppy.layout, puppy.gait, puppy.m);
  SceneSettings settings;
  settings.trajectory = plan.trajectory;
  settings.period = puppy.gait.period();
  settings.travel = plan.travel;
  settings.turn = plan.turn;
  settings.start_qpos = plan.start_qpos;
  settings.start_qvel = plan.start_qvel;
  settings.floor_friction = 0.7;
  return parse_scene(emit_scene(puppy.robot, puppy.robot.xml, settings), "puppy");
}

double& force_of(Scene& scene, int knot, int foot, int axis) {
  return scene.trajectory.at(knot, scene.trajectory.force_column(foot, axis));
}

TEST(InverseDynamics, BouncingRobotIsExplainedByItsForces) {
  const Scene scene = standing_scene(StandingPuppy(0.02));
  const InverseDynamics out = inverse_dynamics(scene, 60);
  EXPECT_LT(out.force_max, 1e-9);  // between the knots as well: both are linear there
  EXPECT_LT(out.torque_max, 1e-9);
  EXPECT_EQ(out.force.size(), 60);
  EXPECT_EQ(out.friction_max, 0.0);
  EXPECT_NEAR(out.friction_coefficient, 0.7, 1e-12);
}

TEST(InverseDynamics, TenPerCentTooMuchForceIsTenPerCentOfTheWeight) {
  Scene scene = standing_scene(StandingPuppy());
  for (int knot = 0; knot < scene.trajectory.knot_count; ++knot)
    for (int foot = 0; foot < 4; ++foot) force_of(scene, knot, foot, 2) *= 1.1;
  const InverseDynamics out = inverse_dynamics(scene, 16);
  EXPECT_NEAR(out.force_max, 0.1, 1e-9);
  EXPECT_NEAR(out.force_rms, 0.1, 1e-9);
}

TEST(InverseDynamics, NamesTheWorstFootAndPhase) {
  Scene scene = standing_scene(StandingPuppy());
  const Trajectory& plan = scene.trajectory;
  force_of(scene, 2, 1, 0) = 0.3 * force_of(scene, 2, 1, 2);
  force_of(scene, 6, 3, 2) *= 0.25;
  const double least = force_of(scene, 6, 3, 2);
  const InverseDynamics out = inverse_dynamics(scene, 60);
  EXPECT_NEAR(out.friction_max, 0.3, 1e-12);
  EXPECT_EQ(out.friction_foot, plan.foot_names[1]);
  EXPECT_EQ(out.friction_phase, 0.25);
  EXPECT_EQ(out.normal_min, least);
  EXPECT_EQ(out.normal_foot, plan.foot_names[3]);
  EXPECT_EQ(out.normal_phase, 0.75);
  EXPECT_EQ(out.worst_phase, 0.75);
  EXPECT_NEAR(out.force_max, 3 * least / StandingPuppy().weight, 1e-6);
  EXPECT_NE(describe(out).find("friction 0.30 of 0.70"), std::string::npos) << describe(out);
}

TEST(InverseDynamics, FootThatPullsAtTheGroundHasNegativeForceAndNoFrictionLeft) {
  Scene scene = standing_scene(StandingPuppy());
  force_of(scene, 3, 0, 2) = -0.5;
  force_of(scene, 3, 0, 1) = 0.1;
  const InverseDynamics out = inverse_dynamics(scene, 8);
  EXPECT_EQ(out.normal_min, -0.5);
  EXPECT_FALSE(std::isfinite(out.friction_max));
}

TEST(InverseDynamics, FeetThatAreDraggedOrRolledByThePlanAreSeen) {
  constexpr double kAngle = 2 * 3.141592653589793 / 8;
  const double smoothed = (2 + std::cos(kAngle)) / 3;  // the B-spline of a sine of 8 knots
  const Scene still = standing_scene(StandingPuppy());
  for (const double slip : inverse_dynamics(still, 8).foot_slip) EXPECT_LT(slip, 1e-9);
  Scene dragged = standing_scene(StandingPuppy()), rolled = standing_scene(StandingPuppy());
  for (int knot = 0; knot < 8; ++knot) {
    const double wave = std::sin(kAngle * knot);
    dragged.trajectory.at(knot, dragged.trajectory.root_column(0)) += 0.02 * wave;
    // The trunk goes round evenly while the feet are said to stand: half a radian ahead.
    rolled.trajectory.at(knot, rolled.trajectory.root_column(4)) = 0.5 * knot / 7;
  }
  for (int foot = 0; foot < 4; ++foot) {
    const auto j = static_cast<std::size_t>(foot);
    const auto drag = inverse_dynamics(dragged, 8), roll = inverse_dynamics(rolled, 8);
    EXPECT_NEAR(drag.foot_slip[j], 4 * 0.02 * smoothed, 2e-4);
    EXPECT_LT(drag.foot_roll[j], 1e-9);
    EXPECT_LT(roll.foot_roll[j], 1e-9);  // a whole cycle: ahead, and back again
    EXPECT_GT(roll.foot_slip[j], 0.02);
  }
  // With the way back in the air, what is left is the way ahead.
  for (int foot = 0; foot < 4; ++foot)
    rolled.trajectory.at(7, rolled.trajectory.contact_column(foot)) = 0.0;
  const auto pitch = [&](double knot) {
    const SplinePhase phase = phase_at(rolled.trajectory, knot * rolled.trajectory.period / 8);
    return spline_point(rolled.trajectory, phase, rolled.trajectory.root_column(4)).value;
  };
  for (const double roll : inverse_dynamics(rolled, 8).foot_roll)
    EXPECT_NEAR(roll, pitch(6) - pitch(0), 3e-3);
}

// A robot that flies along a parabola needs no forces; the same path with half of gravity does.
TEST(InverseDynamics, FreeFallNeedsNothing) {
  for (const double share : {1.0, 0.5}) {
    Scene scene = standing_scene(StandingPuppy());
    Trajectory& plan = scene.trajectory;
    const double step = plan.period / plan.knot_count;
    for (int knot = 0; knot < plan.knot_count; ++knot) {
      const double time = knot * step;
      plan.at(knot, plan.root_column(2)) += 1.0 * time - share * 9.81 * time * time / 2;
      plan.at(knot, plan.root_column(0)) += 0.3 * time;
      for (int foot = 0; foot < 4; ++foot)
        for (int axis = 0; axis < 3; ++axis) force_of(scene, knot, foot, axis) = 0.0;
    }
    PlanDynamics dynamics(*scene.model, plan, std::vector<FootOnBody>(4));
    const int root = scene.joints.root_dof;
    const Eigen::VectorXd& left = dynamics.unexplained(3.3 * step);
    EXPECT_NEAR(left.segment<3>(root).norm() / dynamics.weight(), 1 - share, 1e-9);
    // The legs hang on a trunk that is pulled up now: only in free fall nobody feels them.
    EXPECT_EQ(left.norm() < 1e-8, share == 1.0);
  }
}

}  // namespace
}  // namespace legwright
