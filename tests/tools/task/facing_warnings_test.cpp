// SPDX-License-Identifier: Apache-2.0
#include "tools/task/facing_warnings.hpp"

#include <gtest/gtest.h>

#include "mjcf/propose/declare.hpp"
#include "mjcf/propose/proposals.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/paths.hpp"

namespace legwright {
namespace {

std::vector<std::string> facing_told(const RobotModel& robot, const std::string& forward) {
  return facing_warnings(
      parse_task_file("robot = \"robot.xml\"\n[gait]\nname = \"walk\"\nperiod = 0.8\n[travel]\n" +
                          forward + "velocity = [0.1, 0.0]\n",
                      test::source_dir() + "/examples/puppy/task.toml"),
      robot);
}

/// The puppy with its design parameters declared anew, for where it is said to face.
RobotModel declared(const Forward& forward) {
  const std::string bare = test::undeclared(test::named_robot("puppy"));
  return parse_robot(with_declarations(bare, "puppy.xml",
                                       propose_parameters(bare, "puppy.xml", forward).proposals),
                     "puppy.xml");
}

TEST(FacingWarnings, TiesAcrossTheOtherAxisAreTold) {
  const RobotModel ahead = declared({});
  EXPECT_TRUE(facing_told(ahead, "").empty());
  EXPECT_TRUE(facing_told(ahead, "forward = \"-x\"\n").empty()) << "left and right stay so";
  const std::vector<std::string> turned = facing_told(ahead, "forward = \"+y\"\n");
  ASSERT_EQ(turned.size(), 1u);
  EXPECT_NE(turned[0].find("tie legs as mirror images across y, and this task has the robot face "
                           "+y"),
            std::string::npos)
      << turned[0];
  EXPECT_NE(turned[0].find("init puppy.xml --forward +y --write"), std::string::npos) << turned[0];
  const RobotModel sideways = declared(Eigen::Vector2d::UnitY());
  EXPECT_TRUE(facing_told(sideways, "forward = \"+y\"\n").empty());
}

TEST(FacingWarnings, NamesThatSayOtherwiseAreTold) {
  std::string xml = test::named_robot("puppy");
  for (const auto& [from, to] :
       {std::pair("FL", "XX"), std::pair("FR", "FL"), std::pair("HR", "FR"), std::pair("HL", "HR"),
        std::pair("XX", "HL")})  // a quarter of a turn
    for (std::size_t at = 0; (at = xml.find(from, at)) != std::string::npos;)
      xml.replace(at, 2, to);
  const RobotModel robot = parse_robot(xml, "puppy.xml");
  const std::vector<std::string> out = facing_told(robot, "");
  ASSERT_FALSE(out.empty());
  EXPECT_NE(out[0].find("so it seems to face -y of its trunk's frame, and this task has it face "
                        "+x; forward = \"-y\""),
            std::string::npos)
      << out[0];
  for (const std::string& other : facing_told(robot, "forward = \"-y\"\n"))
    EXPECT_EQ(other.find("seems to face"), std::string::npos) << other;
}

}  // namespace
}  // namespace legwright
