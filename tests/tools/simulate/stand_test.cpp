// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/stand.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include "mjcf/scene/plain_scene.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace legwright {
namespace {

std::filesystem::path example(const std::string& name) {
  return std::filesystem::path(test::source_dir()) / "examples" / name / "robot.xml";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

class StandTest : public testing::Test {
 protected:
  std::filesystem::path scene_of(const std::string& robot_xml) const {
    write_file(folder_.path() / "robot.xml", robot_xml);
    const RobotModel robot = parse_robot(robot_xml, folder_.path() / "robot.xml");
    write_file(folder_.path() / "scene.xml", plain_scene(robot, robot_xml, "robot.xml", 0.8));
    return folder_.path() / "scene.xml";
  }
  std::filesystem::path robot() const { return folder_.path() / "robot.xml"; }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(StandTest, RobotsAtRandomDesignsStandWithoutAWarning) {
  for (const char* name : {"puppy", "quadruped", "hexapod", "biped", "piston_puppy"}) {
    const RobotModel robot = read_robot(example(name));
    for (const double share : {0.0, 0.3, 1.0}) {
      const Eigen::VectorXd s =
          robot.space.clamp((1 - share) * robot.space.lower() + share * robot.space.upper());
      const std::filesystem::path scene = scene_of(rewrite_robot(robot, s));
      const StandingResult stood = stand(scene);
      EXPECT_EQ(stood.warnings.size(), 0u) << name << share;
      EXPECT_NEAR(stood.seconds, 1.0, 1e-9);
      EXPECT_TRUE(differences_in_scene(this->robot(), scene).empty()) << name;
    }
  }
}

TEST_F(StandTest, ThePuppyStays) {
  const StandingResult stood = stand(scene_of(read_file(example("puppy"))));
  EXPECT_NEAR(stood.trunk_before, 0.2045, 1e-3);
  EXPECT_NEAR(stood.trunk_after, stood.trunk_before, 0.02);
}

/// Which of them it is says the README of an export.
TEST_F(StandTest, TellsWhatHoldsAPose) {
  const std::string puppy = read_file(example("puppy"));
  const StandingResult held = stand(scene_of(puppy));
  EXPECT_EQ(held.servos, 12);
  EXPECT_EQ(held.commanded_elsewhere, 0);
  std::string free = puppy;
  const std::size_t from = free.find(" ctrl=\"", free.find("<key "));
  ASSERT_NE(from, std::string::npos);
  free.erase(from, free.find('"', from + 7) + 1 - from);
  const StandingResult elsewhere = stand(scene_of(free));
  EXPECT_EQ(elsewhere.servos, 12);
  EXPECT_EQ(elsewhere.commanded_elsewhere, 12);
}

/// The floor carries it although the robot's default geoms touch nothing: without it, it falls.
TEST_F(StandTest, WithoutFloorItFalls) {
  const std::filesystem::path scene = scene_of(read_file(example("puppy")));
  write_file(scene, with(read_file(scene), "name=\"floor\" type=\"plane\" pos=\"0 0 0\"",
                         "name=\"floor\" type=\"plane\" pos=\"0 0 -50\""));
  EXPECT_LT(stand(scene).trunk_after, -1.0);
}

/// Negative control: a robot that starts at 1e12 m/s.
TEST_F(StandTest, WhatFliesApartIsReported) {
  const std::filesystem::path scene = scene_of(read_file(example("puppy")));
  write_file(robot(), with(read_file(robot()), "<key name=\"home\"",
                           "<key name=\"home\" qvel=\"1e12 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\""));
  const StandingResult stood = stand(scene);
  EXPECT_TRUE(stood.diverged);
  ASSERT_GT(stood.warnings.size(), 0u);
  EXPECT_LT(stood.seconds, 0.1);
  EXPECT_NE(stood.warnings[0].text.find("bad number"), std::string::npos);
}

TEST_F(StandTest, WhatStartsInTheGroundAndIsThrownUpDoesNotStand) {
  const StandingResult stood = stand(scene_of(read_file(example("puppy"))));
  EXPECT_FALSE(stood.flew() || stood.in_ground() || stood.sank());
  const std::filesystem::path scene = scene_of(read_file(example("puppy")));
  write_file(scene, with(read_file(scene), "name=\"floor\" type=\"plane\" pos=\"0 0 0\"",
                         "name=\"floor\" type=\"plane\" pos=\"0 0 0.035\""));
  const StandingResult deep = stand(scene);
  EXPECT_TRUE(deep.in_ground()) << deep.sunk_in;
  EXPECT_NEAR(deep.sunk_in, 0.035, 2e-3);
  write_file(scene, read_file(scene));
  write_file(robot(), with(read_file(robot()), "<key name=\"home\"",
                           "<key name=\"home\" qvel=\"0 0 19 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\""));
  EXPECT_TRUE(stand(scene).flew());
  StandingResult lost;
  lost.trunk_before = 0.2;
  lost.trunk_after = lost.highest = lost.sunk_in = NAN;
  EXPECT_TRUE(lost.flew() && lost.in_ground() && lost.sank());
}

TEST_F(StandTest, WarningsOfAGaitAreReported) {
  const auto warnings = [&](const TinyScene& tiny) {
    write_file(robot(), tiny.xml());
    return warnings_in_gait(robot());
  };
  EXPECT_TRUE(warnings(TinyScene{}).empty());
  TinyScene wild;
  wild.start_qvel = "0 0 0 0 0 0 1e11";
  EXPECT_FALSE(warnings(wild).empty());
}

TEST_F(StandTest, ASceneWithAnotherRobotIsNoticed) {
  const std::filesystem::path scene = scene_of(read_file(example("puppy")));
  write_file(scene, with(read_file(scene), "<option", "<compiler settotalmass=\"9\"/><option"));
  const auto found = differences_in_scene(robot(), scene);
  ASSERT_FALSE(found.empty());
  EXPECT_NE(found.front().find("mass"), std::string::npos) << found.front();
}

}  // namespace
}  // namespace legwright
