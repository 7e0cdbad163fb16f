// SPDX-License-Identifier: Apache-2.0
#include "tools/run/robot_label.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(RobotLabel, RobotsOfOneNameAreToldApart) {
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

}  // namespace
}  // namespace legwright
