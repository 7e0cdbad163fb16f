// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/session_names.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(SessionNames, TasksAndRunsOfOneRobotAreToldApart) {
  EXPECT_EQ(session_name("puppy", "/a/puppy/robot.xml"), "puppy");
  EXPECT_EQ(session_name("puppy", "/a/puppy/sideways_trot.toml"), "puppy, sideways trot");
  EXPECT_EQ(session_name("puppy", "/runs/puppy_found"), "puppy, run puppy_found");
  EXPECT_EQ(session_name("found", "/runs/found"), "found");
  EXPECT_EQ(session_name("spider", "/a/spider.toml"), "spider") << "an assembly";
  EXPECT_EQ(session_name("printed_puppy", "/a/printed_puppy.toml"), "printed_puppy");
  EXPECT_EQ(session_name("robot", ""), "robot");
}

}  // namespace
}  // namespace legwright
