// SPDX-License-Identifier: Apache-2.0
#include "tools/task/stuck_feet.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/source_tree.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/task/starter_task.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

using test::kSource;

/// The hexapod, whose legs swing about upright axes, with the joints that lift one leg coupled.
RobotModel coupled(const std::string& leg) {
  const std::string xml =
      test::undeclared(test::example_robot("hexapod"));  // they move these joints
  return parse_robot(
      test::with(xml, "</mujoco>",
                 fmt::format("<equality><joint joint1=\"{0}_lift\" joint2=\"{0}_knee\"/></equality>"
                             "</mujoco>",
                             leg)),
      "hexapod.xml");
}

TEST(StuckFeet, ALegWithoutAJointThatLiftsIsTold) {
  const RobotModel robot = coupled("ML");
  const std::string text = stuck_foot_text(robot);
  EXPECT_NE(text.find("foot 'ML'"), std::string::npos) << text;
  EXPECT_NE(text.find("only 'ML_swing' moves, which does not"), std::string::npos) << text;
  EXPECT_NE(no_task_text(robot).find("cannot be lifted"), std::string::npos);
  EXPECT_NE(no_task_text(robot).find("--gait tripod"), std::string::npos) << no_task_text(robot);
  const Task task = make_task(
      parse_task_file("robot = \"robot.xml\"\n[gait]\nname = \"tripod\"\nperiod = 0.6\n[travel]\n"
                      "velocity = [0.1, 0.0]\n",
                      kSource / "tests/robots/octopod/task.toml"),
      robot);
  const std::vector<std::string> warnings = task_warnings(task, robot);
  EXPECT_EQ(std::count(warnings.begin(), warnings.end(), text), 1);
}

TEST(StuckFeet, NoneIsWhereLegsHaveAJointThatLifts) {
  for (const char* name : {"biped", "hexapod", "piston_puppy", "puppy", "quadruped"})
    EXPECT_EQ(stuck_foot_text(read_robot(kSource / "examples" / name / "robot.xml")), "") << name;
  for (const char* name :
       {"courser", "crab", "goat", "limper", "mule", "octopod", "ox", "porter", "strider", "wader"})
    EXPECT_EQ(stuck_foot_text(read_robot(kSource / "tests/robots" / name / "robot.xml")), "")
        << name;
}

}  // namespace
}  // namespace legwright
