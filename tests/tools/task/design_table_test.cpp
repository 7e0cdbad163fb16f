// SPDX-License-Identifier: Apache-2.0
#include "tools/task/design_table.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/support/source_tree.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/task/problem.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::kPuppy;

TaskSet with_design(const std::string& table) {
  return parse_task_set(read_file(kPuppy / "sideways.toml") + "\n" + table, kPuppy / "test.toml");
}

/// The message with which a [design] table is refused for the puppy; empty if it is not.
std::string design_error(const std::string& table) {
  try {
    const TaskSet set = with_design(table);
    restricted(read_robot(set.robot).space, set.design, set.file.string(), set.lines);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DesignTable, FreezesAndNarrows) {
  const TaskSet set = with_design(
      "[design]\nfreeze = [\"body_width\"]\n[design.bounds]\nbody_length = [0.2, 0.3]\n");
  const RobotModel robot = read_robot(set.robot);
  const DesignSpace space = restricted(robot.space, set.design, "test.toml", set.lines);
  const int width = space.find("body_width"), length = space.find("body_length");
  ASSERT_EQ(space.size(), robot.space.size());
  EXPECT_TRUE(space.parameters[width].frozen());
  EXPECT_EQ(space.parameters[width].lower, 0.14);
  EXPECT_EQ(space.parameters[length].lower, 0.2);
  EXPECT_EQ(space.parameters[length].upper, 0.3);
  EXPECT_FALSE(space.parameters[0].frozen());
  EXPECT_EQ(space.scale(), robot.space.scale());
}

TEST(DesignTable, KnowsTheBodyThatWasGiven) {
  const TaskSet set = with_design("[design.given]\nbody_length = 0.2\n");
  const RobotModel robot = read_robot(set.robot);
  const DesignSpace space = restricted(robot.space, set.design, "test.toml", set.lines);
  EXPECT_EQ(space.initial(), robot.space.initial()) << "a search begins where the robot is";
  Eigen::VectorXd given = robot.space.initial();
  given[space.find("body_length")] = 0.2;
  EXPECT_EQ(given_body(space, set.design), given);
  EXPECT_NE(design_error("[design.given]\nbody_widht = 0.1\n").find("is 'body_width' meant?"),
            std::string::npos);
  EXPECT_NE(design_error("[design.given]\nbody_width = 9.0\n").find("within the robot's bounds"),
            std::string::npos);
}

TEST(DesignTable, FreezesWhatAPatternMeets) {
  const auto frozen = [](const std::string& list) {
    const TaskSet set = with_design("[design]\nfreeze = [" + list + "]\n");
    const DesignSpace space =
        restricted(read_robot(set.robot).space, set.design, "test.toml", set.lines);
    std::string names;
    for (const DesignParameter& parameter : space.parameters)
      if (parameter.frozen()) names += parameter.name + " ";
    return names;
  };
  EXPECT_EQ(frozen(R"("front_*_length")"),
            "front_thigh_length front_shank_length front_foot_length ");
  EXPECT_EQ(frozen(R"("body_?????", "hind_[ft]*_length")"),
            "hind_thigh_length hind_foot_length body_width ");
  EXPECT_EQ(frozen(R"("*")"), [] {
    std::string all;
    for (const auto& parameter : read_robot(kPuppy / "robot.xml").space.parameters)
      all += parameter.name + " ";
    return all;
  }());
  const std::string error = design_error("[design]\nfreeze = [\"frnt_*\", \"body_*\"]\n");
  EXPECT_NE(error.find("design.freeze: no design parameter of the robot is like 'frnt_*'; the "
                       "nearest: front_thigh_length, front_shank_length, front_foot_length"),
            std::string::npos)
      << error;
  EXPECT_EQ(error.find("body_*"), std::string::npos) << error;
}

/// Bounds of a task are not the robot's: a design that is written keeps those of its file.
TEST(DesignTable, LeavesTheRobotsFileAlone) {
  RobotModel robot = read_robot(kPuppy / "robot.xml");
  const int width = robot.space.find("body_width");
  robot.space.parameters[width].lower = robot.space.parameters[width].upper = 0.14;
  Eigen::VectorXd s = robot.space.initial();
  s[0] = 0.07;
  const std::string text = rewrite_robot(robot, s);
  EXPECT_NE(text.find("\"legwright/body_width\" data=\"0.14 0.112 0.182\""), std::string::npos);
  s[width] = 0.15;
  EXPECT_THROW(rewrite_robot(robot, s), std::invalid_argument);
}

TEST(DesignTable, FaultsAreReportedWithTheirCure) {
  EXPECT_EQ(design_error("[design]\nfreeze = [\"body_width\"]\n"), "");
  EXPECT_NE(design_error("[design]\nfreeze = [\"body_widht\"]\n").find("is 'body_width' meant?"),
            std::string::npos);
  EXPECT_NE(design_error("[design]\nfreeze = [3]\n").find("expected names"), std::string::npos);
  EXPECT_NE(design_error("[design]\nfrozen = []\n").find("design.frozen"), std::string::npos);
  EXPECT_NE(design_error("[design.bounds]\nbody_width = [0.1, 0.15]\n").find("within the robot's"),
            std::string::npos);
  EXPECT_NE(design_error("[design.bounds]\nbody_width = 0.1\n").find("an array of 2 numbers"),
            std::string::npos);
}

}  // namespace
}  // namespace legwright
