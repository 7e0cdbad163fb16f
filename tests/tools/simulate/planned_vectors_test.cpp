// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/planned_vectors.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/played_state.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr int kKnots = 10;
constexpr double kPeriod = 0.5, kTurn = 0.6, kRadius = 0.3;

Vector3d on_circle(double angle) {
  return {0.1 + kRadius * std::sin(angle), -0.2 - kRadius * std::cos(angle), 0.15};
}

// A root and a foot that go round a circle evenly, the root with a heading that is its tangent and
// a slight, steady roll; the foot is pushed outwards.
Trajectory round_a_circle() {
  Trajectory plan = blank_trajectory({"tail"}, {"F"}, kKnots, kPeriod);
  for (int knot = 0; knot < kKnots; ++knot) {
    const double angle = kTurn * knot / kKnots;
    const Vector3d root = on_circle(angle), foot = root + Vector3d(0, 0, -0.1);
    const Vector3d outwards(std::sin(angle), -std::cos(angle), 3.0);
    for (int k = 0; k < 3; ++k) {
      plan.at(knot, plan.root_column(k)) = root[k];
      plan.at(knot, plan.foot_column(0, k)) = foot[k];
      plan.at(knot, plan.force_column(0, k)) = outwards[k];
    }
    plan.at(knot, plan.root_column(5)) = angle;
  }
  const Vector3d travel = on_circle(kTurn) - on_circle(0.0);
  plan.travel = {travel.x(), travel.y(), 0.0};
  plan.turn = kTurn;
  return plan;
}

TEST(PlannedMotion, TurningPlanStaysOnItsCircle) {
  const Trajectory plan = round_a_circle();
  const Vector3d centre(0.1, -0.2, 0.15);
  for (const double time : {0.0, 0.01, 0.03, 0.26, 0.48, 0.5, 0.51, 3.3, 12.34, -0.7}) {
    const PlannedPoint root = planned_point(plan, phase_at(plan, time), plan.root_column(0));
    const Vector3d arm = root.value - centre;
    EXPECT_NEAR(arm.norm(), kRadius, 1e-3 * kRadius) << time;
    EXPECT_NEAR(root.rate.dot(arm), 0.0, 1e-4) << time;
    const double speed = kRadius * kTurn / kPeriod;
    EXPECT_NEAR(root.rate.norm(), speed, 1e-3 * speed) << time;
    EXPECT_NEAR(root.acceleration.norm(), speed * speed / kRadius, 2e-3 * speed * speed / kRadius)
        << time;
    const double angle = std::atan2(arm.x(), -arm.y());
    EXPECT_NEAR(std::remainder(angle - kTurn * time / kPeriod, 2 * std::numbers::pi), 0.0, 1e-9)
        << time;
  }
  // Moving the next cycle without turning it, as a plan that goes straight may, leaves the circle.
  const SplinePhase start = phase_at(plan, 0.0);
  const SplinePoint wrong = spline_point(plan, start, plan.root_column(1), plan.travel[1]);
  EXPECT_GT(std::abs(wrong.acceleration -
                     planned_point(plan, start, plan.root_column(0)).acceleration.y()),
            1.0);
}

TEST(PlannedMotion, ForcesTurnWithThePlan) {
  const Trajectory plan = round_a_circle();
  for (const double time : {0.0, 0.2, 0.49, 1.7}) {
    const SplinePhase phase = phase_at(plan, time);
    const Vector3d force = planned_force(plan, phase, 0);
    const Vector3d arm =
        planned_point(plan, phase, plan.foot_column(0, 0)).value - Vector3d(0.1, -0.2, 0.05);
    EXPECT_NEAR(force.z(), 3.0, 1e-12);
    EXPECT_NEAR(force.head<2>().dot(arm.head<2>()) / kRadius, 1.0, 2e-3) << time;
  }
}

TEST(PlannedMotion, PlayedRootTurnsAboutTheVertical) {
  const auto model = compile_model(R"(<mujoco><worldbody><body name="trunk"><freejoint/>
    <geom size="0.1"/><body pos="0.2 0 0"><joint name="tail"/><geom size="0.05"/></body>
    </body></worldbody></mujoco>)",
                                   "ball");
  Trajectory plan = round_a_circle();
  for (int knot = 0; knot < kKnots; ++knot) plan.at(knot, plan.root_column(3)) = 0.02;
  const JointMap map = map_joints(*model, plan.joint_names);
  const auto pose = [&](double time) {
    const PlayedState state = played_state(*model, map, plan, time);
    const Eigen::VectorXd q = state.qpos.segment<4>(map.root_qpos + 3);
    return Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  };
  for (const double time : {0.1, 0.37}) {
    const Eigen::Quaterniond first = pose(time), later = pose(time + 9 * kPeriod);
    const Eigen::Quaterniond rotated(Eigen::AngleAxisd(9 * kTurn, Vector3d::UnitZ()));
    EXPECT_LT((rotated * first).angularDistance(later), 1e-9);
    // Up stays as far from the vertical, which adding 9 turns to the rotation vector would not do.
    EXPECT_NEAR((later * Vector3d::UnitZ()).z(), (first * Vector3d::UnitZ()).z(), 1e-12);
  }
  // A level trunk goes on smoothly into the next cycle.
  for (int knot = 0; knot < kKnots; ++knot) plan.at(knot, plan.root_column(3)) = 0.0;
  const PlayedState before = played_state(*model, map, plan, 4 * kPeriod - 1e-7);
  const PlayedState after = played_state(*model, map, plan, 4 * kPeriod + 1e-7);
  EXPECT_TRUE(before.qpos.isApprox(after.qpos, 1e-6));
  EXPECT_TRUE(before.qvel.isApprox(after.qvel, 1e-5));
}

}  // namespace
}  // namespace legwright
