// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/home_ctrl.hpp"

#include <gtest/gtest.h>

#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

RobotFiles robot_of(const std::string& name) {
  return RobotFiles::read(test::source_path("tests/robots/" + name + "/robot.xml"));
}

TEST(HomeCtrl, HoldsPositionServosWhereTheKeyframeHasThem) {
  const RobotFiles dog = robot_of("servo_dog"), held = with_home_ctrl(dog);
  const ModelPointer model = compile_mjcf(held.text(), held.file());
  const int home = home_keyframe(*model);
  for (int i = 0; i < model->nu; ++i) {
    const int joint = model->actuator_trnid[2 * i];
    EXPECT_DOUBLE_EQ(model->key_ctrl[home * model->nu + i],
                     home_qpos(*model)[model->jnt_qposadr[joint]])
        << i;
  }
  EXPECT_EQ(with_home_ctrl(held).text(), held.text());
  std::string without = held.text();
  const std::size_t at = without.find(" ctrl=\"0.6 -1.15");
  ASSERT_NE(at, std::string::npos);
  without.erase(at, without.find('"', at + 7) + 1 - at);
  EXPECT_EQ(without, dog.text()) << "all else stays";
}

TEST(HomeCtrl, WhatTheFileSaysHolds) {
  for (const char* name : {"courser", "lurcher"})  // torque motors; no keyframe
    EXPECT_EQ(with_home_ctrl(robot_of(name)).text(), robot_of(name).text()) << name;
  const auto puppy = RobotFiles::read(test::puppy_file());
  EXPECT_EQ(with_home_ctrl(puppy).text(), puppy.text()) << "its keyframe has one";
}

TEST(HomeCtrl, StaysWithinTheRangesOfServos) {
  const RobotFiles dog = RobotFiles::from_text(
      test::with(robot_of("servo_dog").text(), "<position ", "<position ctrlrange=\"-1 0.5\" "),
      "dog.xml");
  const ModelPointer model = compile_mjcf(dog.text(), "dog.xml");
  const auto ctrl = holding_ctrl(*model, home_qpos(*model), "dog.xml");
  ASSERT_TRUE(ctrl);
  for (const double value : *ctrl) EXPECT_TRUE(value == 0.5 || value == -1.0) << value;
}

}  // namespace
}  // namespace legwright
