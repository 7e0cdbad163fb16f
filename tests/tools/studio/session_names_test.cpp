// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/session_names.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(SessionNames, RobotsOfOneNameAreToldApart) {
  const auto label = [](const char* model, const char* origin, const char* robot) {
    return robot_label(model, origin, robot);
  };
  EXPECT_EQ(label("puppy", "/a/b/robot.xml", "/a/b/robot.xml"), "puppy");
  EXPECT_EQ(label("robot", "/a/dog/robot.xml", "/a/dog/robot.xml"), "dog");
  EXPECT_EQ(label("MuJoCo Model", "/a/dog/mjcf/scene.xml", "/a/dog/mjcf/scene.xml"), "dog");
  EXPECT_EQ(label("robot", "/a/tasks/trot.toml", "/a/dog/robot.xml"), "dog");
  EXPECT_EQ(label("robot", "/runs/found", "/runs/found/inputs/robot.xml"), "found");
  const char* dropped = "/state/robots/20260301-140500-dropped-0/mine.xml";
  EXPECT_EQ(label("robot", dropped, dropped), "mine");
  const char* nameless = "/state/robots/20260301-140500-dropped-0/robot.xml";
  EXPECT_EQ(label("robot", nameless, nameless), "robot");
  const char* kept = "/state/sessions/20260301-140500-dog-0/robot/robot.xml";
  EXPECT_EQ(label("robot", "/a/dog/robot.xml", kept), "dog") << "a session that is taken up";
  EXPECT_EQ(label("robot", "/a/dog/trot.toml", kept), "dog");
}

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
