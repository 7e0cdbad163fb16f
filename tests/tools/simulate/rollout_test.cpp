// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/rollout.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/json_file.hpp"
#include "tools/validate/measure.hpp"
#include "tools/validate/records.hpp"
#include "tools/validate/validation.hpp"

namespace legwright {
namespace {

const WantedMotion kStanding;

Measurements play(const TinyScene& tiny, const WantedMotion& wanted, int cycles = 6) {
  RolloutOptions options;
  options.cycles = cycles;
  return measure(parse_scene(tiny.xml(), "tiny"), wanted, wanted.velocity, options);
}

TEST(Rollout, StandingTableStands) {
  const Measurements run = play(TinyScene{}, kStanding);
  EXPECT_FALSE(run.fall) << run.fall->cause;
  EXPECT_EQ(run.cycles, 6);
  EXPECT_NEAR(run.seconds, 2.4, 1e-9);
  EXPECT_TRUE(run.warnings.empty());
  ASSERT_TRUE(run.velocity);
  EXPECT_LT(run.velocity->norm(), 0.002);
  EXPECT_FALSE(run.speed_ratio);  // means nothing here
  EXPECT_LT(run.tilt_max, 0.01);
  EXPECT_EQ(run.saturated_share, 0.0);
  EXPECT_GT(run.joints[0].torque_rms, 0.0);
  EXPECT_LT(run.joints[0].torque_peak, run.joints[0].torque_limit);
  EXPECT_GT(run.penetration_max, 0.0);
  EXPECT_LT(run.penetration_max, 0.001);
  EXPECT_TRUE(judge({run}, kStanding, "wag").pass);
}

TEST(Rollout, GlidingTableHasItsSpeedAndSlips) {
  TinyScene tiny;
  tiny.friction = 0.0;
  tiny.wag = 0.0;
  tiny.start_qvel = "0 0.3 0 0 0 0 0";
  const Measurements run = play(tiny, {{0.0, 0.3}, 0.0});
  ASSERT_TRUE(run.speed_ratio);
  EXPECT_NEAR(*run.speed_ratio, 1.0, 1e-3);
  EXPECT_NEAR(*run.plan_speed_ratio, 1.0, 1e-3);
  EXPECT_NEAR(*run.lateral_drift, 0.0, 1e-3);
  EXPECT_NEAR(run.feet[1].slip_mean, 0.3 * 0.4, 1e-2);  // it stands all the time: slip of a cycle
  EXPECT_TRUE(judge({run}, {{0.0, 0.3}, 0.0}, "glide").pass);
  const Measurements across = play(tiny, {{0.3, 0.0}, 0.0});  // the same motion, another wish
  EXPECT_NEAR(*across.speed_ratio, 0.0, 1e-3);
  EXPECT_NEAR(*across.lateral_drift, 0.3, 1e-3);
  EXPECT_FALSE(judge({across}, {{0.3, 0.0}, 0.0}, "glide").pass);
}

TEST(Rollout, SpeedIsSeenInTheRobotsOwnHeading) {
  TinyScene tiny;
  tiny.friction = 0.0;
  tiny.wag = 0.0;
  constexpr double kYaw = 1.2;
  tiny.start_qpos = fmt::format("0 0 0.1 {} 0 0 {} 0", std::cos(kYaw / 2), std::sin(kYaw / 2));
  tiny.start_qvel = fmt::format("{} {} 0 0 0 0 0", 0.3 * std::cos(kYaw), 0.3 * std::sin(kYaw));
  const Measurements run = play(tiny, {{0.3, 0.0}, 0.0});
  EXPECT_NEAR(*run.speed_ratio, 1.0, 1e-3);
  EXPECT_NEAR(run.heading_at_start, kYaw, 1e-6);
  tiny.start_qvel = "0.3 0 0 0 0 0 0";  // along the world's x is not ahead for it
  const Measurements aside = play(tiny, {{0.3, 0.0}, 0.0});
  EXPECT_NEAR(*aside.speed_ratio, std::cos(kYaw), 1e-3);
  EXPECT_NE(judge({aside}, {{0.3, 0.0}, 0.0}, "glide").line.find("turns the trunk by 1.20 rad"),
            std::string::npos);
}

TEST(Rollout, TurningAboutTheCentreOfMassIsNoDrift) {
  // Its tail of 10 g puts the table's COM 1.24 mm behind the trunk's origin, which so runs round
  // it.
  TinyScene tiny;
  tiny.friction = 0.0;
  tiny.wag = 0.0;
  tiny.start_qvel = "0 0.0061881 0 0 0 5 0";
  const Measurements run = play(tiny, {{0.0, 0.0}, 5.0}, 10);
  ASSERT_TRUE(run.velocity);
  EXPECT_LT(run.velocity->norm(), 2e-4);
  tiny.start_qvel = "0 0 0 0 0 5 0";  // the origin at rest, the COM not
  EXPECT_GT(play(tiny, {{0.0, 0.0}, 5.0}, 10).velocity->norm(), 5e-4);
}

TEST(Rollout, SpinIsMeasuredOverManyTurns) {
  TinyScene tiny;
  tiny.friction = 0.0;
  tiny.wag = 0.0;
  tiny.start_qvel = "0 0 0 0 0 5 0";
  const Measurements run = play(tiny, {{0.0, 0.0}, 5.0}, 10);
  ASSERT_TRUE(run.turn_ratio);
  EXPECT_NEAR(*run.turn_ratio, 1.0, 0.02);
  EXPECT_LT(std::abs(run.heading_drift), 0.5);  // of 20 rad
}

TEST(Rollout, TableThatTipsOverFalls) {
  TinyScene tiny;
  tiny.start_qpos = "0 0 0.25 0.8 0.6 0 0 0";  // rolled by 1.29 rad, in the air
  const Measurements run = play(tiny, kStanding);
  ASSERT_TRUE(run.fall);
  EXPECT_LT(run.seconds, 1.0);
  EXPECT_FALSE(run.velocity);
  const Verdict verdict = judge({run}, kStanding, "wag");
  EXPECT_FALSE(verdict.pass);
  EXPECT_NE(verdict.reasons.at(0).find("falls"), std::string::npos);
}

TEST(Rollout, TrunkOnTheGroundIsAFall) {
  TinyScene tiny;
  tiny.start_qpos =
      "0 0 0.3 0.9 0.43588989 0 0 0";  // rolled by 0.9 rad: an edge of the trunk lands first
  tiny.start_qvel = "0 0 0 0.5 0 0 0";
  const Measurements run = play(tiny, kStanding);
  ASSERT_TRUE(run.fall);
}

/// Fall and sink are judged by the trunk, wherever its frame is.
TEST(Rollout, ATrunkWhoseFrameIsOnTheGroundHasNotFallen) {
  const Scene scene = parse_scene(TinyScene{}.xml(), "tiny");
  const int trunk = scene.joints.root_body;
  ModelPointer model(mj_copyModel(nullptr, scene.model.get()));
  const DataPointer data = make_data(*model);
  mj_resetDataKeyframe(model.get(), data.get(), scene.start_key);
  mj_forward(model.get(), data.get());
  const double height = trunk_com_height(*model, *data, trunk);
  EXPECT_NEAR(height, 0.1, 1e-9);
  EXPECT_FALSE(find_fall(scene, *data, 0.0, height, {}));
  data->xpos[3 * trunk + 2] = 0.0;  // the frame's origin says nothing
  EXPECT_FALSE(find_fall(scene, *data, 0.0, height, {}));
  data->xipos[3 * trunk + 2] = 0.39 * height;
  ASSERT_TRUE(find_fall(scene, *data, 0.0, height, {}));
  EXPECT_NE(find_fall(scene, *data, 0.0, height, {})->cause.find("sank"), std::string::npos);
}

TEST(Rollout, DivergenceIsReportedAndNeverReset) {
  TinyScene tiny;
  tiny.start_qvel = "0 0 0 0 0 0 1e11";
  const Measurements run = play(tiny, kStanding);
  EXPECT_TRUE(run.diverged);
  ASSERT_FALSE(run.warnings.empty());
  EXPECT_LT(run.seconds, 0.1);
  EXPECT_FALSE(judge({run}, kStanding, "wag").pass);
}

TEST(Rollout, WeakServoIsSaturated) {
  TinyScene tiny;
  tiny.wag = 1.0;
  tiny.torque_limit = 0.001;
  const Measurements run = play(tiny, kStanding);
  EXPECT_GT(run.saturated_share, 0.1);
  EXPECT_LE(run.joints[0].torque_peak, 0.001 + 1e-12);
  ASSERT_TRUE(run.joints[0].saturated_time);
  EXPECT_GE(*run.joints[0].saturated_time, TinyScene::kPeriod) << "the first cycle does not count";
  EXPECT_GT(run.tracking_rms, 0.1);
  EXPECT_FALSE(judge({run}, kStanding, "wag").pass);
}

TEST(Rollout, FootThatDoesNotLiftAsPlannedIsEarly) {
  TinyScene tiny;
  tiny.swinging_foot = true;
  const Measurements run = play(tiny, kStanding);
  EXPECT_GT(run.feet[0].stances, 0);
  EXPECT_LT(run.feet[0].touchdown_mean, -0.1);
  EXPECT_EQ(run.feet[1].touchdown_max, 0.0);
}

TEST(Rollout, RecordsFramesAtTheirTimes) {
  RolloutOptions options;
  options.cycles = 2;
  options.frame_until = 0.5;
  const Scene scene = parse_scene(TinyScene{}.xml(), "tiny");
  const Rollout played = rollout(scene, options);
  ASSERT_EQ(played.frames.size(), 51U);
  EXPECT_NEAR(played.frames[50].time, 0.5, 1e-9);
  EXPECT_EQ(played.frames[0].qpos.size(), static_cast<std::size_t>(scene.model->nq));
  EXPECT_DOUBLE_EQ(played.frames[0].qpos[2], 0.1);
}

class Validation : public testing::Test {
 protected:
  Validation()
      : folder_(std::filesystem::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::create_directories(folder_);
    write_file(folder_ / "good.xml", TinyScene{}.xml(), Durability::process);
    TinyScene tipped;
    tipped.start_qpos = "0 0 0.25 0.8 0.6 0 0 0";
    write_file(folder_ / "bad.xml", tipped.xml(), Durability::process);
  }
  ~Validation() override { std::filesystem::remove_all(folder_); }

  std::string text(int threads) const {
    ValidationOptions options;
    options.cycles = 4;
    options.threads = threads;
    std::string out;
    for (const auto& one : validate_scenes({{folder_ / "bad.xml", {}}, {folder_ / "good.xml", {}}},
                                           kStanding, "wag", options)) {
      out += to_text(json_of(metrics_by_gain(one))) +
             to_text(json_of(verdict_record(one.verdict))) + playback_csv(one);
    }
    return out;
  }

  std::filesystem::path folder_;
};

TEST_F(Validation, SameBytesEveryTimeAndForAnyNumberOfThreads) {
  const std::string first = text(2);
  EXPECT_EQ(text(2), first);
  EXPECT_EQ(text(1), first);
  EXPECT_EQ(first.find("nan"), std::string::npos);
}

TEST_F(Validation, JudgesEachSceneInItsPlace) {
  const auto results = validate_scenes({{folder_ / "bad.xml", {}}, {folder_ / "good.xml", {}}},
                                       kStanding, "wag", {.cycles = 4});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_FALSE(results[0].verdict.pass);
  EXPECT_TRUE(results[1].verdict.pass) << results[1].verdict.line;
  EXPECT_EQ(results[1].at_gains.size(), 3U);
  EXPECT_EQ(results[1].qpos_names.size(), 8U);
  EXPECT_NEAR(results[1].robot_mass, 1.01, 1e-9);
}

TEST_F(Validation, MissingSceneIsAFileError) {
  EXPECT_THROW(validate_scenes({{folder_ / "none.xml", {}}}, kStanding, "wag"), std::system_error);
}

}  // namespace
}  // namespace legwright
