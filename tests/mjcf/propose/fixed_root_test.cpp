// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/fixed_root.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

const char* const kFixedFile = "fixed.xml";

/// Strider as drawn by somebody who fixed it to the world.
std::string fixed_strider() {
  const std::string xml = test::read_file(test::source_path("tests/robots/strider/robot.xml"));
  return test::with(test::with(xml, "<freejoint/>", ""), "0 0 0.115267 1 0 0 0 ", "");
}

std::string with_root_freed(const std::string& text, std::string* told) {
  return with_freed_trunk(RobotFiles::from_text(text, kFixedFile), told).main_text();
}

std::string with_root_freed(const std::string& text) {
  std::string told;
  return with_root_freed(text, &told);
}

TEST(FixedRoot, ATrunkThatIsFixedToTheWorldFloats) {
  const std::string given = fixed_strider();
  std::string told;
  const std::string made = with_root_freed(given, &told);
  EXPECT_EQ(told, "a free joint for the trunk 'body', which is drawn fixed to the world");
  EXPECT_EQ(std::count(made.begin(), made.end(), '\n'),
            std::count(given.begin(), given.end(), '\n'));
  EXPECT_NE(made.find("><freejoint name=\"root\"/>"), std::string::npos);
  EXPECT_THROW((void)parse_robot(given, kFixedFile), InputError);
  const RobotModel robot = parse_robot(made, kFixedFile);
  EXPECT_EQ(robot.root_body, "body");
  std::string again;
  EXPECT_EQ(with_root_freed(made, &again), made);
  EXPECT_EQ(again, "");
}

/// A keyframe shows the robot where it was.
TEST(FixedRoot, KeyframesFollow) {
  const std::string given = fixed_strider();
  const ModelPointer was = compile_mjcf(given, kFixedFile),
                     is = compile_mjcf(with_root_freed(given), kFixedFile);
  ASSERT_EQ(was->nkey, is->nkey);
  ASSERT_GT(was->nkey, 0);
  const DataPointer before = kinematics_at(*was, was->key_qpos, kFixedFile),
                    after = kinematics_at(*is, is->key_qpos, kFixedFile);
  ASSERT_EQ(was->ngeom, is->ngeom);
  for (int g = 0; g < was->ngeom; ++g)
    EXPECT_LT((vector_at(before->geom_xpos, g) - vector_at(after->geom_xpos, g)).norm(), 1e-9);
}

TEST(FixedRoot, OtherFilesStayAsTheyAre) {
  const std::string free = test::read_file(test::source_path("tests/robots/strider/robot.xml"));
  EXPECT_EQ(with_root_freed(free), free);
  const std::string arm =
      "<mujoco><worldbody><body name=\"stand\"><geom size=\"0.1\"/><body name=\"arm\"><joint/>"
      "<geom size=\"0.1\"/></body></body></worldbody></mujoco>";
  EXPECT_EQ(with_root_freed(arm), arm) << "one limb is an arm";
  const std::string two = test::with(arm, "</worldbody>",
                                     "<body name=\"door\"><joint/><geom size=\"0.1\"/></body>"
                                     "</worldbody>");
  EXPECT_EQ(with_root_freed(two), two);
  const std::string moved = test::with(arm, "<geom size=\"0.1\"/><body name=\"arm\">",
                                       "<joint type=\"slide\"/><geom size=\"0.1\"/>"
                                       "<body name=\"leg\"><joint/><geom size=\"0.1\"/></body>"
                                       "<body name=\"arm\">");
  EXPECT_EQ(with_root_freed(moved), moved) << "its root moves";
  const std::string broken = test::with(fixed_strider(), "<geom", "<geum");
  EXPECT_EQ(with_root_freed(broken), broken) << "its reader tells the fault";
}

}  // namespace
}  // namespace legwright
