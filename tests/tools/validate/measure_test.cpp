// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/measure.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/validate/records.hpp"

namespace legwright {
namespace {

// Five cycles of a table whose plan begins so far in its cycle.
Measurements measured_from(const char* t0, double contacts_until) {
  TinyScene tiny;
  tiny.swinging_foot = true;
  std::string xml = tiny.xml();
  const std::string gains = "<config key=\"kp\"";
  xml.insert(xml.find(gains), "<config key=\"t0\" value=\"" + std::string(t0) + "\"/>");
  RolloutOptions options;
  options.cycles = 5;
  return measure(parse_scene(xml, "tiny"), {}, Eigen::Vector2d::Zero(), options,
                 {.contacts_until = contacts_until});
}

TEST(Measure, ContactsOfAPlanThatBeginsLaterLastAsLong) {
  for (const double until : {0.6, 10.0}) {
    for (const char* t0 : {"0.1", "4.1", "-0.3"}) {
      const Measurements run = measured_from(t0, until);
      ASSERT_EQ(run.feet[1].contacts.size(), 1U) << t0;  // stands from the start, well-nigh
      const auto [from, to] = run.feet[1].contacts[0];
      EXPECT_NEAR(from, 0.1, 0.05) << t0;  // on the plan's clock
      EXPECT_NEAR(to, 0.1 + std::min(until, 5 * TinyScene::kPeriod), 2 * TinyScene::kTimeStep)
          << t0;
    }
  }
}

TEST(Measure, WholeCyclesBeforeTheStartChangeNothing) {
  const Measurements early = measured_from("0.1", 1.0), late = measured_from("4.1", 1.0);
  for (std::size_t foot = 0; foot < early.feet.size(); ++foot) {
    EXPECT_EQ(late.feet[foot].stances, early.feet[foot].stances) << foot;
    EXPECT_NEAR(late.feet[foot].touchdown_mean, early.feet[foot].touchdown_mean,
                2 * TinyScene::kTimeStep)
        << foot;
    EXPECT_NEAR(late.feet[foot].liftoff_mean, early.feet[foot].liftoff_mean,
                2 * TinyScene::kTimeStep)
        << foot;
  }
  EXPECT_EQ(measured_from("0", 1.0).feet[0].stances, early.feet[0].stances);
}

/// All numbers of a roll-out as text.
std::string record_of(const Measurements& run) {
  SceneValidation validation;
  validation.at_gains = {run};
  return json_of(metrics_by_gain(validation).front().second).dump();
}

TEST(GaitMeasurement, GoesOnFromWhereItStoodToTheBit) {
  TinyScene tiny;
  tiny.swinging_foot = true;
  const Scene scene = parse_scene(tiny.xml(), "tiny");
  const auto in_one_go = [&](int cycles) {
    RolloutOptions options;
    options.cycles = cycles;
    return record_of(measure(scene, {}, Eigen::Vector2d::Zero(), options));
  };
  GaitMeasurement measurement(scene, {}, Eigen::Vector2d::Zero());
  EXPECT_EQ(record_of(measurement.play_to(2)), in_one_go(2));
  EXPECT_EQ(record_of(measurement.play_to(5)), in_one_go(5));
  EXPECT_EQ(record_of(measurement.play_to(5)), in_one_go(5)) << "nothing is left to play";
  EXPECT_NE(in_one_go(2), in_one_go(5));
}

TEST(GaitMeasurement, StaysFallen) {
  TinyScene tiny;
  tiny.start_qpos = "0 0 0.25 0.8 0.6 0 0 0";  // rolled by 1.29 rad, in the air
  const Scene scene = parse_scene(tiny.xml(), "tiny");
  GaitMeasurement measurement(scene, {}, Eigen::Vector2d::Zero());
  const Measurements first = measurement.play_to(4);
  ASSERT_TRUE(first.fall) << "this test shows nothing";
  EXPECT_EQ(record_of(measurement.play_to(9)), record_of(first));
}

}  // namespace
}  // namespace legwright
