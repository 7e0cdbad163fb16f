// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/paths.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;

Task task_of(const std::string& forward, const std::string& style = "footprint = [0.12, 0.09]") {
  const RobotModel robot = parse_robot(test::named_robot("puppy"), "puppy.xml");
  return make_task(
      parse_task_file("robot = \"robot.xml\"\n[gait]\nname = \"walk\"\nperiod = "
                      "0.8\n[style]\n" +
                          style + "\n[travel]\n" + forward + "velocity = [0.1, 0.02]\n",
                      test::source_dir() + "/examples/puppy/task.toml"),
      robot);
}

TEST(TaskThatFaces, BackwardIsTheSamePatternFromTheOtherEnd) {
  const Task ahead = task_of(""), back = task_of("forward = \"-x\"\n");
  EXPECT_EQ(back.velocity, Vector2d(-0.1, -0.02));
  const std::vector<int> opposite{3, 2, 1, 0};  // feet in the order of the puppy's file
  for (int j = 0; j < 4; ++j) {
    const auto other = static_cast<std::size_t>(opposite[static_cast<std::size_t>(j)]);
    for (int i = 0; i < ahead.gait.knot_count(); ++i)
      EXPECT_EQ(ahead.gait.in_contact(i, j), back.gait.in_contact(i, static_cast<int>(other)));
    EXPECT_EQ(ahead.footprint->at(static_cast<std::size_t>(j)), -back.footprint->at(other));
  }
}

TEST(TaskThatFaces, PairsOfItsStyleGoAheadAndToTheLeftAsItLooks) {
  const Task task = task_of("forward = \"+y\"\n",
                            "footprint = [[0.1, 0.05], [0.1, -0.05], [-0.1, 0.06], [-0.1, -0.06]]\n"
                            "com_path = [[0.01, 0.0], [0.0, 0.02]]\n"
                            "foot_targets.FL = [[0.11, -0.04], [-0.11, -0.04]]");
  // As it looks, HL is the front left foot; then FL, HR and FR. The file has FL, FR, HL and HR.
  // Ahead is y of the trunk, left is −x.
  const std::vector<Vector2d> places{{0.05, 0.1}, {0.06, -0.1}, {-0.05, 0.1}, {-0.06, -0.1}};
  EXPECT_EQ(*task.footprint, places);
  EXPECT_EQ(task.com_path, (std::vector<Vector2d>{{0.0, 0.01}, {-0.02, 0.0}}));
  EXPECT_EQ(task.foot_targets.front(), (std::vector<Vector2d>{{0.04, 0.11}, {0.04, -0.11}}));
}

TEST(TaskThatFaces, NowhereIsRefused) {
  try {
    task_of("forward = \"north\"\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("is 'north'; expected the axis"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace legwright
