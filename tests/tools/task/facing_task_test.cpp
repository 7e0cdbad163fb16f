// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/paths.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;

Task task_of(const std::string& forward) {
  const RobotModel robot = parse_robot(test::named_robot("puppy"), "puppy.xml");
  return make_task(parse_task_file("robot = \"robot.xml\"\n[gait]\nname = \"walk\"\nperiod = "
                                   "0.8\n[style]\nfootprint = [0.12, 0.09]\n[travel]\n" +
                                       forward + "velocity = [0.1, 0.02]\n",
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
