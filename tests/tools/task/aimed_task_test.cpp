// SPDX-License-Identifier: Apache-2.0
// What a task asks of the plan beside what it wants of the walk.
#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "tests/support/source_tree.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

using test::kPuppy;

TaskFile aimed_file(const std::string& rest) {
  return parse_task_file(
      "robot = \"robot.xml\"\n[gait]\nname = \"trot\"\nperiod = 0.4\n[travel]\n"
      "velocity = [0.0, 0.1]\n" +
          rest,
      kPuppy / "test.toml");
}

Task aimed_task(const std::string& rest) {
  static const RobotModel puppy = read_robot(kPuppy / "robot.xml");
  return make_task(aimed_file(rest), puppy);
}

TEST(AimedTask, GoesBesideWhatIsWanted) {
  const std::string keys = "turn_rate = 0.2\naim_speed = 1.1\naim_turn_rate = -0.05\n";
  const TaskFile file = aimed_file(keys);
  EXPECT_EQ(file.velocity.y(), 0.1);
  EXPECT_EQ(file.turn_rate, 0.2);
  const Task task = aimed_task(keys);
  EXPECT_NEAR(task.velocity.y(), 0.11, 1e-15);
  EXPECT_NEAR(task.turn_rate, 0.17, 1e-15);
}

TEST(AimedTask, DoesNotTurnOnASlope) {
  try {
    (void)aimed_task("aim_turn_rate = 0.1\n[ground]\nslope_along = 0.1\n");
    FAIL() << "turns on a slope";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("travel.aim_turn_rate"), std::string::npos)
        << error.what();
  }
}

TEST(AimedTask, WidensTheFootprintAcrossTheWay) {
  const Task task = aimed_task("[style]\nfootprint = [0.1, 0.06]\n"),
             wide = aimed_task("[style]\nfootprint = [0.1, 0.06]\nstance_width = 1.5\n");
  for (std::size_t foot = 0; foot < task.footprint->size(); ++foot) {  // it goes sideways
    EXPECT_NEAR((*wide.footprint)[foot].x(), 1.5 * (*task.footprint)[foot].x(), 1e-15);
    EXPECT_EQ((*wide.footprint)[foot].y(), (*task.footprint)[foot].y());
  }
  EXPECT_EQ(wide.follow_hips, false) << "as a footprint that a task gives";
  EXPECT_EQ(aimed_task("[style]\nstance_width = 1.5\n").follow_hips, true);
}

}  // namespace
}  // namespace legwright
