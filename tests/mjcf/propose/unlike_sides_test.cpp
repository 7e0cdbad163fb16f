// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/unlike_sides.hpp"

#include <gtest/gtest.h>

#include "mjcf/propose/facing.hpp"
#include "mjcf/read/read_robot.hpp"
#include "tests/support/paths.hpp"
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
  EXPECT_NE(told.find("differ in length"), std::string::npos) << told;
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

TEST(UnlikeSides, FeetThreeMillimetresOffAreTiedAndTold) {
  const std::string told = tied(read_robot(kRobots / "wader/robot.xml"));
  EXPECT_NE(told.find("taken for mirror images and tied"), std::string::npos) << told;
  EXPECT_NE(told.find(" 3 mm"), std::string::npos) << told;
}

}  // namespace
}  // namespace legwright
