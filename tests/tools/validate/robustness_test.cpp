// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/robustness.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "optimizer/motion/task.hpp"
#include "plugin/spline.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/json_file.hpp"
#include "tools/validate/floor_friction.hpp"
#include "tools/validate/records.hpp"
#include "tools/validate/robustness_limits.hpp"

namespace legwright {
namespace {

constexpr double kG = 9.81;
const WantedMotion kStanding;

class Disturbed : public testing::Test {
 protected:
  std::filesystem::path write(const TinyScene& tiny) const {
    write_file(folder_.path() / "tiny.xml", tiny.xml(), Durability::process);
    return folder_.path() / "tiny.xml";
  }
  DisturbableScene scene(const TinyScene& tiny = {}) const {
    return DisturbableScene(write(tiny), Eigen::Vector2d::Zero());
  }
  /// Velocity of the trunk at the end of so many cycles of 0.4 s.
  static Eigen::Vector3d end_velocity(const DisturbableScene& from, const Disturbance& disturbance,
                                      int cycles, double push_time = 0.1) {
    Scene scene = from.with(disturbance);
    Eigen::Vector3d velocity;
    rollout(scene, disturbed_rollout(scene, disturbance, cycles, push_time),
            [&](const RolloutSample& sample) {
              velocity = Eigen::Map<const Eigen::Vector3d>(sample.data.qvel);
            });
    return velocity;
  }
  test::TemporaryFolder folder_;
};

TEST_F(Disturbed, NothingChangesNothing) {
  const DisturbableScene from = scene();
  EXPECT_EQ(from.nothing().floor_friction, 0.8);
  const Scene same = from.with(from.nothing());
  EXPECT_EQ(same.model->opt.timestep, from.undisturbed().model->opt.timestep);
  EXPECT_EQ(same.model->body_mass[1], from.undisturbed().model->body_mass[1]);
}

TEST_F(Disturbed, FrictionIsThatOfWhatTheFeetStandOn) {
  // A wall that feet pass through comes first, and the floor is a box.
  std::string xml = TinyScene{}.xml();
  const std::string plane = "type=\"plane\" size=\"10 10 0.1\"";
  const std::size_t at = xml.find(plane);
  ASSERT_NE(at, std::string::npos);
  xml.replace(at, plane.size(), "type=\"box\" size=\"10 10 0.1\" pos=\"0 0 -0.1\" priority=\"1\"");
  const std::string world = "<worldbody>";
  xml.insert(xml.find(world) + world.size(),
             "<geom name=\"ghost\" type=\"plane\" size=\"1 1 1\" priority=\"2\" friction=\"0.1\" "
             "contype=\"2\" conaffinity=\"0\"/>");
  write_file(folder_.path() / "box.xml", xml, Durability::process);
  const DisturbableScene from(folder_.path() / "box.xml", Eigen::Vector2d::Zero());
  EXPECT_EQ(floor_friction(from.undisturbed()), 0.8);
  EXPECT_EQ(from.nothing().floor_friction, 0.8);
  Disturbance ice = from.nothing();
  ice.floor_friction = 0.05;
  const Scene changed = from.with(ice);
  EXPECT_EQ(floor_friction(changed), 0.05);
  EXPECT_EQ(changed.model->geom_friction[0], 0.1);  // the ghost keeps its own
}

TEST_F(Disturbed, FrictionCountsWhereFeetAndGroundDiffer) {
  Scene scene = parse_scene(TinyScene{}.xml(), "tiny");
  mjModel& model = *scene.model;
  const int floor = 0, foot = scene.foot_geom[2];
  ASSERT_EQ(model.geom_bodyid[floor], 0);
  model.geom_friction[3 * foot] = 0.3;
  EXPECT_EQ(floor_friction(scene), 0.8);  // the larger of each pair
  model.geom_priority[foot] = 1;
  EXPECT_EQ(floor_friction(scene), 0.3);  // the slipperiest pair
  model.geom_contype[floor] = model.geom_conaffinity[floor] = 0;
  EXPECT_TRUE(std::isinf(floor_friction(scene)));
  EXPECT_TRUE(footings(scene).empty());
}

TEST_F(Disturbed, PushGivesTheRobotItsVelocity) {
  TinyScene tiny;
  tiny.friction = 0.0;
  tiny.wag = 0.0;
  const DisturbableScene from = scene(tiny);
  Disturbance push = from.nothing();
  push.push_forward = 0.2;
  push.push_left = -0.1;
  const Eigen::Vector3d velocity = end_velocity(from, push, 1);
  EXPECT_NEAR(velocity.x(), 0.2, 5e-3);  // its tail swings a little
  EXPECT_NEAR(velocity.y(), -0.1, 5e-3);
  EXPECT_NEAR(end_velocity(from, from.nothing(), 1).norm(), 0.0, 1e-4);
}

/// A robot that looks along y of its trunk: left is −x.
TEST_F(Disturbed, AheadAndLeftAreThoseOfWhereItFaces) {
  TinyScene tiny;
  tiny.wag = 0.0;
  tiny.friction = 0.0;
  const Eigen::Vector2d forward = Eigen::Vector2d::UnitY();
  const DisturbableScene from(write(tiny), Eigen::Vector2d::Zero(), forward);
  Disturbance all = from.nothing();
  all.push_forward = 0.2;
  all.push_left = -0.1;
  all.roll = 0.3;
  Scene scene = from.with(all);
  const RolloutOptions options = disturbed_rollout(scene, all, 1, 0.1, forward);
  const DataPointer data = make_data(*scene.model);
  mj_resetDataKeyframe(scene.model.get(), data.get(), scene.start_key);
  options.prepare(*data);
  mj_kinematics(scene.model.get(), data.get());
  const mjtNum* rotation = data->xmat + 9 * scene.joints.root_body;
  EXPECT_NEAR(rotation[2], std::sin(0.3), 1e-9);  // its upper side goes to its right, which is x
  EXPECT_NEAR(rotation[5], 0.0, 1e-9);
  options.step(*data, 0.1);
  const mjtNum* force = data->xfrc_applied + 6 * scene.joints.root_body;
  EXPECT_NEAR(force[1], 2.0 * force[0], 1e-9);
  EXPECT_GT(force[1], 0.0);

  Disturbance slope = from.nothing();
  slope.slope_along = 0.1;
  const Scene tilted = from.with(slope);
  const mjtNum* gravity = tilted.model->opt.gravity;
  EXPECT_NEAR(gravity[1], -kG * std::sin(0.1), 1e-9);
}

TEST_F(Disturbed, FrictionOfTheFloorStopsWhatSlides) {
  const DisturbableScene from = scene();
  Disturbance slip = from.nothing();
  slip.push_forward = 1.0;
  slip.floor_friction = 0.05;
  // The push is over at 0.15 s and took friction away from 0.1 s on.
  const double expected = 1.0 - 0.05 * kG * (0.8 - 0.1);
  EXPECT_NEAR(end_velocity(from, slip, 2).x(), expected, 0.03);
  slip.floor_friction = 0.8;
  EXPECT_NEAR(end_velocity(from, slip, 2).x(), 0.0, 1e-2);
}

TEST_F(Disturbed, SlopeSlidesItAsItShould) {
  const DisturbableScene from = scene();
  Disturbance slope = from.nothing();
  slope.floor_friction = 0.1;
  slope.slope_along = 0.3;  // uphill ahead: it slides back
  const double a = kG * (std::sin(0.3) - 0.1 * std::cos(0.3));
  EXPECT_NEAR(end_velocity(from, slope, 1).x(), -0.4 * a, 0.1 * a);
  slope.slope_along = 0.0;
  slope.slope_across = 0.3;
  EXPECT_LT(end_velocity(from, slope, 1).y(), -0.3 * a);  // rising to the left
  slope.slope_across = 0.05;                              // below the angle of friction
  EXPECT_NEAR(end_velocity(from, slope, 1).norm(), 0.0, 2e-2);
}

TEST_F(Disturbed, ASlopeComesOnTopOfTheScenesOwn) {
  TinyScene tiny;
  std::string xml = tiny.xml();
  const std::size_t end = xml.rfind("</mujoco>");
  ASSERT_NE(end, std::string::npos);
  const Eigen::Vector3d own = -kG * up_on_slope({1.0, 0.0}, 0.2, 0.0);
  xml.insert(end, fmt::format("<option gravity=\"{} {} {}\"/>", own.x(), own.y(), own.z()));
  write_file(folder_.path() / "slope.xml", xml, Durability::process);
  const DisturbableScene from(folder_.path() / "slope.xml", Eigen::Vector2d::UnitX());
  const auto gravity = [&](double along, double across) {
    Disturbance slope = from.nothing();
    slope.slope_along = along;
    slope.slope_across = across;
    const Scene scene = from.with(slope);
    return Eigen::Vector3d(scene.model->opt.gravity);
  };
  EXPECT_LT((gravity(0.0, 0.0) - own).norm(), 1e-12);
  EXPECT_LT((gravity(-0.2, 0.0) - Eigen::Vector3d(0, 0, -kG)).norm(), 1e-12);  // level again
  EXPECT_LT((gravity(0.1, 0.05) + kG * up_on_slope({1.0, 0.0}, 0.3, 0.05)).norm(), 1e-12);
}

TEST_F(Disturbed, MassWeighsOnTheFloor) {
  const DisturbableScene from = scene();
  for (const double scale : {0.5, 1.0, 3.0}) {
    Disturbance mass = from.nothing();
    mass.mass_scale = scale;
    Scene heavy = from.with(mass);
    EXPECT_NEAR(heavy.model->body_subtreemass[1], 1.01 * scale, 1e-9);
    double force = 0.0;
    rollout(heavy, disturbed_rollout(heavy, mass, 2, 0.1), [&](const RolloutSample& sample) {
      force = 0.0;
      for (int c = 0; c < sample.data.ncon; ++c) {
        mjtNum wrench[6];
        mj_contactForce(&sample.model, &sample.data, c, wrench);
        force += wrench[0];
      }
    });
    EXPECT_NEAR(force, 1.01 * scale * kG, 0.05 * scale * kG) << scale;
  }
}

TEST_F(Disturbed, TiltedStartStandsOnItsLowestFoot) {
  const DisturbableScene from = scene();
  Disturbance tilt = from.nothing();
  tilt.roll = 0.2;
  tilt.pitch = -0.1;
  Scene tilted = from.with(tilt);
  const DataPointer data = make_data(*tilted.model);
  mj_resetDataKeyframe(tilted.model.get(), data.get(), tilted.start_key);
  disturbed_rollout(tilted, tilt, 1, 0.1).prepare(*data);
  mj_kinematics(tilted.model.get(), data.get());
  const mjtNum* rotation = data->xmat + 9 * tilted.joints.root_body;
  EXPECT_NEAR(rotation[8], std::cos(0.2) * std::cos(-0.1), 1e-9);
  double lowest = 1.0;
  for (const int foot : tilted.foot_geom)
    lowest = std::min<double>(lowest, data->geom_xpos[3 * foot + 2] - 0.02);
  EXPECT_NEAR(lowest, 0.0, 1e-9);
  EXPECT_LT(data->geom_xpos[3 * tilted.foot_geom[1] + 2],   // its right side,
            data->geom_xpos[3 * tilted.foot_geom[0] + 2]);  // rolled to
}

TEST_F(Disturbed, LateServosPushWithTheForceOfEarlier) {
  TinyScene tiny;
  tiny.wag = 0.5;
  tiny.torque_limit = 10.0;
  const DisturbableScene from = scene(tiny);
  Disturbance late = from.nothing();
  late.delay = 0.00375;  // 3.75 steps of 1 ms: 3.25 steps ago, and half a step is the step's own
  Scene scene = from.with(late);
  std::vector<double> law, felt;
  const RolloutOptions plain = disturbed_rollout(scene, late, 1, 0.1);
  RolloutOptions options = plain;
  options.step = [&](mjData& data, double time) {
    const double q = data.qpos[scene.joints.qpos[0]], v = data.qvel[scene.joints.dof[0]];
    const auto target = spline_point(scene.trajectory, phase_at(scene.trajectory, time),
                                     scene.trajectory.target_column(0));
    law.push_back(2.0 * (target.value - q) + 0.05 * (target.rate - v));
    plain.step(data, time);
    felt.push_back(data.qfrc_actuator[scene.joints.dof[0]]);
  };
  rollout(scene, options);
  ASSERT_GT(felt.size(), 300U);
  for (std::size_t n = 4; n < felt.size(); ++n)
    ASSERT_NEAR(felt[n], 0.75 * law[n - 3] + 0.25 * law[n - 4], 1e-12) << n;
  EXPECT_GT(std::abs(felt[50] - law[50]), 1e-3);  // not the same as without delay
  EXPECT_EQ(scene.model->actuator_biasprm[1], 0.0);
  EXPECT_EQ(from.with(late, DelayStep::fine).model->opt.timestep, 0.25e-3);
}

TEST_F(Disturbed, GainsAreThoseOfTheScaledScene) {
  const DisturbableScene from = scene();
  Disturbance stiff = from.nothing();
  stiff.gain_scale = 4.0;
  const Scene scene = from.with(stiff);
  EXPECT_DOUBLE_EQ(scene.model->actuator_biasprm[1], -8.0);
  EXPECT_DOUBLE_EQ(scene.model->actuator_biasprm[2], -0.1);
}

TEST_F(Disturbed, MarginIsWhereATableTipsOver) {
  // Set down rolled by 45°, its centre of mass is above the feet of one side.
  RobustnessOptions options;
  options.samples = 0;
  options.cycles = 4;
  options.only = {"initial_roll"};
  options.tested["initial_roll"] = {-1.4, 1.4};
  const Robustness robustness = measure_robustness(write({}), kStanding, options);
  EXPECT_FALSE(robustness.nominal_cause);
  ASSERT_EQ(robustness.margins.size(), 1U);
  const Margin& margin = robustness.margins[0];
  ASSERT_TRUE(margin.low && margin.high);
  EXPECT_NEAR(*margin.high, std::numbers::pi / 4, 0.2);
  EXPECT_NEAR(*margin.low, -*margin.high, 0.06);  // it is symmetric, but for its tail
  EXPECT_LT(*margin.high, *margin.high_fails);
  EXPECT_LT(*margin.high_fails - *margin.high, 0.05);
  EXPECT_NE(margin.high_cause.find("falls after"), std::string::npos);
  EXPECT_GE(margin.rollouts, 12);
}

TEST_F(Disturbed, AskingForMoreChangesNoMarginThatWasFound) {
  TinyScene askew;  // rolled by 0.5 rad already: it tips over within what is tested by default
  askew.start_qpos = "0 0 0.138 0.96891 0.24740 0 0 0";
  const auto margin = [&](double low, double high) {
    RobustnessOptions options;
    options.samples = 0;
    options.cycles = 4;
    options.bisections = 2;
    options.only = {"initial_roll"};
    options.tested["initial_roll"] = {low, high};
    return measure_robustness(write(askew), kStanding, options);
  };
  const Robustness by_default = margin(-0.5, 0.5);
  ASSERT_FALSE(by_default.nominal_cause);
  ASSERT_TRUE(by_default.margins.at(0).high);
  const auto text = [](const Robustness& robustness) {
    return to_text(json_of(robustness_record(robustness)));
  };
  EXPECT_EQ(text(margin(-0.5, 1.4)), text(by_default));
  EXPECT_EQ(text(margin(-0.1, 0.1)), text(by_default));  // never tested less far either
}

TEST_F(Disturbed, FactorsThatAreAskedBeyondTheDefaultStartFromItsEnd) {
  RobustnessOptions options;
  options.samples = 0;
  options.cycles = 4;
  options.only = {"initial_roll", "delay"};
  options.tested["initial_roll"] = {-0.5, 1.4};
  options.tested["delay"] = {0.0, 1.0};
  const Robustness robustness = measure_robustness(write({}), kStanding, options);
  ASSERT_EQ(robustness.margins.size(), 2U);
  const Margin &delay = robustness.margins[0], &roll = robustness.margins[1];
  EXPECT_EQ(delay.factor.name, "delay");
  ASSERT_TRUE(roll.high);
  EXPECT_GE(*roll.high, 0.5);
  EXPECT_EQ(roll.factor.tested_high, 1.4);
  EXPECT_FALSE(roll.low);
  EXPECT_EQ(roll.factor.tested_low, -0.5);
  EXPECT_EQ(delay.factor.tested_high, 1.0);  // a table stands with late servos, too
  EXPECT_EQ(delay.factor.tested_low, 0.0);
}

TEST_F(Disturbed, SameBytesForAnyNumberOfThreads) {
  const auto text = [&](int threads) {
    RobustnessOptions options;
    options.samples = 6;
    options.cycles = 4;
    options.bisections = 1;
    options.only = {"initial_roll", "push_left", "gains"};
    options.threads = threads;
    options.tested["initial_roll"] = {-1.4, 1.4};
    return to_text(json_of(robustness_record(measure_robustness(write({}), kStanding, options))));
  };
  const std::string one = text(1);
  EXPECT_EQ(text(3), one);
  EXPECT_NE(one.find("\"survived\": 6"), std::string::npos) << one;
  EXPECT_EQ(one.find("nan"), std::string::npos);
}

TEST_F(Disturbed, DrawsAreSpreadAndNamed) {
  RobustnessOptions options;
  options.samples = 4;
  options.cycles = 4;
  options.bisections = 0;
  const Robustness robustness = measure_robustness(write({}), kStanding, options);
  EXPECT_EQ(robustness.survival.samples, 4);
  const Json json = json_of(robustness_record(robustness));
  EXPECT_EQ(json["factors"].size(), 11U);
  EXPECT_NEAR(json["monte_carlo"]["spread"]["floor_friction"][0].get<double>(), 0.64, 1e-12);
  EXPECT_EQ(json["monte_carlo"]["spread"].size(), 11U);
}

TEST_F(Disturbed, WhatFailsUndisturbedHasNoMargins) {
  const Robustness robustness = measure_robustness(write({}), {{0.3, 0.0}, 0.0});
  ASSERT_TRUE(robustness.nominal_cause);
  EXPECT_EQ(*robustness.nominal_cause, "goes at less than half the wanted speed");
  EXPECT_TRUE(robustness.margins.empty());
  EXPECT_EQ(robustness_lines(robustness).size(), 1U);
}

TEST(Failure, IsAFallOrAnotherMotionThanWanted) {
  Measurements run;
  const WantedMotion circle{{0.1, 0.0}, 0.3};
  run.speed_ratio = run.turn_ratio = 0.5;
  EXPECT_FALSE(failure(run, circle));
  run.turn_ratio = 0.49;
  EXPECT_EQ(failure(run, circle), "turns at less than half the wanted rate");
  run.turn_ratio = 2.1;
  EXPECT_EQ(failure(run, circle), "turns at more than twice the wanted rate");
  run.speed_ratio.reset();
  EXPECT_EQ(failure(run, circle), "goes at less than half the wanted speed");
  run.speed_ratio = std::nan("");
  EXPECT_TRUE(failure(run, circle));
  EXPECT_FALSE(failure(run, kStanding));
  run.fall = Fall{1.0, "the trunk sank"};
  EXPECT_EQ(failure(run, kStanding), "the trunk sank");
  run.diverged = true;
  EXPECT_EQ(failure(run, kStanding), "the simulation diverges");
}

TEST(Wilson, KnownIntervals) {
  const auto [low, high] = wilson_interval(187, 200);
  EXPECT_NEAR(low, 0.89197, 1e-4);
  EXPECT_NEAR(high, 0.96162, 1e-4);
  EXPECT_DOUBLE_EQ(wilson_interval(200, 200).second, 1.0);
  EXPECT_NEAR(wilson_interval(200, 200).first, 0.98115, 1e-4);
  EXPECT_DOUBLE_EQ(wilson_interval(0, 10).first, 0.0);
}

}  // namespace
}  // namespace legwright
