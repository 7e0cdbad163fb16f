// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/comparison.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/files/json_file.hpp"
#include "tools/validate/records.hpp"

namespace legwright {
namespace {

constexpr double kWeight = 1.01 * 9.81;

Scene scene_of(const TinyScene& tiny) { return parse_scene(tiny.xml(), "tiny"); }

std::optional<Comparison> compare(const Scene& scene, const WantedMotion& wanted, int cycles = 5) {
  ComparisonWatch watch(scene, wanted);
  RolloutOptions options;
  options.cycles = cycles;
  const Measurements measured =
      measure(scene, wanted, wanted.velocity, options, {}, nullptr,
              [&](const RolloutSample& sample) { watch.observe(sample); });
  return watch.finish(measured);
}

const Curve& named(const Comparison& comparison, const std::string& name) {
  for (const auto& curve : comparison.curves)
    if (curve.name == name) return curve.curve;
  throw std::out_of_range(name);
}

TEST(PhaseCurves, CyclesAreComparedByTheirMeansWithinABin) {
  PhaseCurves curves(1, 2);
  const auto cycle = [&](bool keep, std::initializer_list<double> first, double second) {
    for (const double value : first) curves.add(0, Eigen::VectorXd::Constant(1, value));
    curves.add(1, Eigen::VectorXd::Constant(1, second));
    curves.end_cycle(keep);
  };
  cycle(false, {1000.0}, 1000.0);
  cycle(true, {0.0, 8.0}, 1.0);
  cycle(true, {5.0, 5.0, 5.0}, 3.0);
  const Curve curve = curves.curve(0);
  EXPECT_EQ(curves.cycles(), 2);
  EXPECT_EQ(curve.mean, Eigen::Vector2d(4.5, 2.0));
  EXPECT_EQ(curve.low, Eigen::Vector2d(4.0, 1.0));
  EXPECT_EQ(curve.high, Eigen::Vector2d(5.0, 3.0));
  curves.restart();
  cycle(true, {7.0}, 7.0);
  EXPECT_EQ(curves.curve(0).low, Eigen::Vector2d(7.0, 7.0));
}

TEST(Comparison, StandingTableStandsOnItsFeet) {
  Scene scene = scene_of(TinyScene{});
  Trajectory& plan = scene.trajectory;
  for (int knot = 0; knot < plan.knot_count; ++knot) {
    plan.at(knot, plan.com_column(2)) = plan.at(knot, plan.root_column(2)) = 0.1;
    for (int foot = 0; foot < 4; ++foot) {
      plan.at(knot, plan.force_column(foot, 2)) = kWeight / 4;
      plan.at(knot, plan.foot_column(foot, 2)) = 0.02;
    }
  }
  const auto comparison = compare(scene, {});
  ASSERT_TRUE(comparison);
  EXPECT_EQ(comparison->cycles, (std::pair{2, 4}));
  EXPECT_EQ(comparison->phases.size(), 60);
  EXPECT_NEAR(comparison->phases[0], 0.5 / 60, 1e-15);
  double normal = 0.0;
  for (const auto& foot : comparison->feet) {
    normal += foot.normal.mean.mean();
    EXPECT_NEAR(foot.normal.mean.mean(), foot.normal.planned->mean(), 0.05 * kWeight);
    EXPECT_NEAR(foot.height.mean.mean(), foot.height.planned->mean(), 1e-3);
    EXPECT_EQ(foot.contact.low.minCoeff(), 1.0);
    EXPECT_EQ(foot.contact.planned->minCoeff(), 1.0);
    EXPECT_LT(foot.slip_speed.high.maxCoeff(), 1e-2);
    EXPECT_EQ(foot.touchdown.worst, 0.0);
  }
  EXPECT_NEAR(normal, kWeight, 1e-2 * kWeight);
  EXPECT_NEAR(named(*comparison, "com_height").mean.mean(), 0.1, 1e-3);
  EXPECT_NEAR(named(*comparison, "trunk_height").planned->mean(), 0.1, 1e-12);
  const JointComparison& tail = comparison->joints.at(0);
  EXPECT_NEAR((tail.angle.mean - *tail.angle.planned).norm() / std::sqrt(60.0),
              named(*comparison, "tracking").mean.norm() / std::sqrt(60.0), 1e-4);
  EXPECT_LT((tail.angle.mean - *tail.angle.planned).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_GT(tail.angle.mean.maxCoeff() - tail.angle.mean.minCoeff(), 0.2);
  EXPECT_EQ(tail.torque_limit, 1.0);
  EXPECT_EQ(comparison->cycle_table.size(), 5u);
  EXPECT_GT(comparison->cycle_table[3].power, 0.0);
  EXPECT_FALSE(comparison->cycle_table[3].speed_ratio);
  EXPECT_NE(describe(*comparison).find("normal forces within"), std::string::npos);
}

TEST(Comparison, PlanThatAsksForMoreForceThanTheWeightIsSeen) {
  Scene scene = scene_of(TinyScene{});
  Trajectory& plan = scene.trajectory;
  for (int knot = 0; knot < plan.knot_count; ++knot)
    for (int foot = 0; foot < 4; ++foot) plan.at(knot, plan.force_column(foot, 2)) = kWeight / 2;
  const auto comparison = compare(scene, {});
  for (const auto& foot : comparison->feet)
    EXPECT_GT(foot.normal.planned->mean() - foot.normal.mean.mean(), 0.2 * kWeight);
}

TEST(Comparison, GlidingTableIsBrakedByAllFriction) {
  TinyScene tiny;
  tiny.friction = 0.02;
  tiny.wag = 0.0;
  tiny.start_qvel = "0 0.4 0 0 0 0 0";
  const auto comparison = compare(scene_of(tiny), {{0.0, 0.4}, 0.0});
  ASSERT_TRUE(comparison);
  // 0.02 g brakes it by 0.078 m/s in each cycle of 0.4 s; cycles 2 to 4 are looked at.
  const Curve& speed = named(*comparison, "speed");
  EXPECT_NEAR(speed.mean[0], 0.4 - 0.02 * 9.81 * 3 * 0.4, 5e-3);
  EXPECT_NEAR(speed.high[0] - speed.low[0], 2 * 0.02 * 9.81 * 0.4, 5e-3);
  EXPECT_NEAR(*comparison->cycle_table[0].speed_ratio, 1 - 0.02 * 9.81 * 0.2 / 0.4, 5e-3);
  EXPECT_NEAR(comparison->paths.measured.front().x(), -0.00124, 1e-5);  // the tail's 10 g
  EXPECT_EQ(comparison->paths.measured.front().y(), 0.0);
  EXPECT_NEAR(comparison->paths.measured.back().y(), 0.4 * 2 - 0.02 * 9.81 * 2, 5e-3);
  for (const auto& foot : comparison->feet) {
    EXPECT_NEAR(foot.friction.mean.mean(), 0.02, 1e-3);
    EXPECT_NEAR(foot.tangential.mean.mean(), 0.02 * foot.normal.mean.mean(), 1e-3);
    EXPECT_NEAR(foot.slip_speed.mean.mean(), speed.mean.mean(), 1e-2);
    EXPECT_EQ(foot.slip_speed.planned->maxCoeff(), 0.0);
  }
}

TEST(Comparison, HeadingIsAgainstThePlansTurn) {
  TinyScene tiny;
  tiny.friction = 0.0;
  tiny.wag = 0.0;
  tiny.start_qvel = "0 0 0 0 0 5 0";
  Scene scene = scene_of(tiny);
  const auto straight = compare(scene, {});
  EXPECT_NEAR(straight->cycle_table[4].heading, 5 * 2.0,
              0.2);  // the trunk turned by 10 rad unasked
  EXPECT_GT(named(*straight, "heading_error").mean.minCoeff(), 3.0);
  Trajectory& plan = scene.trajectory;
  plan.turn = 2.0;  // what 5 rad/s are in 0.4 s
  for (int knot = 0; knot < plan.knot_count; ++knot)
    plan.at(knot, plan.root_column(5)) = plan.turn * knot / plan.knot_count;
  const auto turning = compare(scene, {{0.0, 0.0}, 5.0});
  EXPECT_NEAR(turning->cycle_table[4].heading, 0.0, 0.4);
  EXPECT_NEAR(*turning->cycle_table[4].turn_ratio, 1.0, 0.02);
  EXPECT_LT(named(*turning, "heading_error").mean.cwiseAbs().maxCoeff(), 0.4);
  EXPECT_LT(named(*turning, "yaw").mean.cwiseAbs().maxCoeff(), 0.05);
}

TEST(Comparison, LiftedFootIsPlannedOffTheGround) {
  TinyScene tiny;
  tiny.swinging_foot = true;
  const auto comparison = compare(scene_of(tiny), {});
  const FootComparison& lifted = comparison->feet[0];
  EXPECT_EQ(lifted.contact.planned->minCoeff(), 0.0);
  EXPECT_NEAR(lifted.contact.planned->mean(), 0.5, 0.05);
  EXPECT_EQ(lifted.contact.mean.minCoeff(), 1.0);  // nothing lifts it
  EXPECT_LT(lifted.touchdown.mean, -0.05);         // on the ground since the stride began
  EXPECT_GT(lifted.liftoff.mean, 0.05);            // and until it ended
}

TEST(Comparison, EarlyFallLeavesNothingToCompare) {
  TinyScene tiny;
  tiny.start_qpos = "0 0 0.25 0.8 0.6 0 0 0";
  EXPECT_FALSE(compare(scene_of(tiny), {}));
  // One cycle is none, two are enough.
  EXPECT_FALSE(compare(scene_of(TinyScene{}), {}, 1));
  const auto two = compare(scene_of(TinyScene{}), {}, 2);
  ASSERT_TRUE(two);
  EXPECT_EQ(two->cycles, (std::pair{1, 1}));
}

TEST(Comparison, JsonHoldsWhatWasMeasured) {
  const auto comparison = compare(scene_of(TinyScene{}), {});
  const Json json = json_of(comparison_record(std::nullopt, comparison));
  EXPECT_EQ(json["schema"], "legwright/comparison");
  EXPECT_TRUE(json["initial"].is_null());
  const Json& design = json["result"];
  EXPECT_EQ(design["cycles"], (Json{2, 4}));
  EXPECT_EQ(design["feet"].size(), 4u);
  EXPECT_EQ(design["feet"][0]["force_normal_N"]["mean"].size(), design["phases"].size());
  EXPECT_EQ(design["curves"][0]["name"], "speed");
  EXPECT_TRUE(design["curves"].back()["planned"].is_null());  // nobody plans to miss
  EXPECT_EQ(design["cycle_table"].size(), 5u);
  EXPECT_TRUE(design["cycle_table"][0]["speed_ratio"].is_null());
  EXPECT_EQ(design["inverse_dynamics"]["residual_force_share"].size(), design["phases"].size());
  EXPECT_EQ(design["path_xy"]["planned"].size(), design["path_xy"]["measured"].size());
  EXPECT_EQ(to_text(json),
            to_text(json_of(comparison_record(std::nullopt, compare(scene_of(TinyScene{}), {})))));
}

}  // namespace
}  // namespace legwright
