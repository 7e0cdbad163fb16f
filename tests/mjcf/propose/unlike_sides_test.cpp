// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/unlike_sides.hpp"

#include <gtest/gtest.h>

#include "mjcf/propose/facing.hpp"
#include "mjcf/read/read_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/source_tree.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

const fs::path kRobots = fs::path(test::source_dir()) / "tests/robots";

std::string tied(const RobotModel& robot) {
  const Facing facing = facing_of(robot);
  return tied_though_unlike(robot,
                            find_limbs(robot.morphology, robot.space.initial(), facing.ahead),
                            sides_across(facing.ahead));
}

std::string all_of(const RobotModel& robot) {
  std::string out;
  for (const std::string& sentence : unlike_sides(robot)) out += sentence + "\n";
  return out;
}

TEST(UnlikeSides, OfALegThatIsTooShortAndAnAxisThatIsNoMirrorImageAreTold) {
  const std::string told = all_of(read_robot(kRobots / "limper/robot.xml"));
  EXPECT_NE(told.find("feet 'RL_foot' and 'RR_foot' are 0.18 and 0.15 m from the last joints"),
            std::string::npos)
      << told;
  EXPECT_NE(told.find("are no mirror images"), std::string::npos) << told;
}

TEST(UnlikeSides, OfRobotsThatAreDrawnWellNothingIsTold) {
  for (const char* name : {"courser", "crab", "goat", "mule", "octopod", "ox", "porter",
                           "servo_dog", "strider", "wader"}) {
    const RobotModel robot = read_robot(kRobots / name / "robot.xml");
    EXPECT_EQ(all_of(robot), "") << name;
    const bool is_off = std::string(name) == "wader";
    EXPECT_EQ(tied(robot).empty(), !is_off) << name << ": " << tied(robot);
  }
}

TEST(UnlikeSides, LinksAndRangesThatDifferAreNamed) {
  const std::string dog = test::read_file(test::source_path("tests/robots/servo_dog/robot.xml"));
  const std::string narrow = all_of(parse_robot(
      test::with(dog, "name=\"HR_knee\" range=\"-2.2 0.4\"", "name=\"HR_knee\" range=\"-2.2 0.1\""),
      "dog.xml"));
  EXPECT_NE(narrow.find("the ranges of 'HL_knee' and 'HR_knee', -2.2 to 0.4 rad and -2.2 to 0.1 "
                        "rad, are no mirror images"),
            std::string::npos)
      << narrow;
  const std::string quadruped = test::undeclared(test::example_robot("quadruped"));
  const std::string shank = "name=\"HR_shank\" pos=\"0 0 -0.09\"";
  const std::string short_thigh = all_of(parse_robot(
      test::with(quadruped, shank, "name=\"HR_shank\" pos=\"0 0 -0.07\""), "quadruped.xml"));
  EXPECT_NE(short_thigh.find("'HL_thigh' and 'HR_thigh' differ in length, 0.09 and 0.07 m"),
            std::string::npos)
      << short_thigh;
}

TEST(UnlikeSides, FeetThreeMillimetresOffAreTiedAndTold) {
  const std::string told = tied(read_robot(kRobots / "wader/robot.xml"));
  EXPECT_NE(told.find("taken for mirror images and tied"), std::string::npos) << told;
  EXPECT_NE(told.find(" 3 mm"), std::string::npos) << told;
}

}  // namespace
}  // namespace legwright
