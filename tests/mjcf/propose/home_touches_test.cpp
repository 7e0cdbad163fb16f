// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/home_touches.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

/// Two legs 10 cm apart, of which the hips turn outwards or inwards; two balls of the right one
/// touch its trunk.
const char* const kPair = R"(<mujoco><compiler angle="radian"/><worldbody>
  <geom name="wall" type="box" size="0.01 1 1" pos="0 0 0"/>
  <body name="trunk" pos="0 0 1"><freejoint/><geom type="box" size="0.1 0.02 0.02" mass="1"/>
    <body name="left" pos="0 0.05 0"><joint name="l" axis="1 0 0"/>
      <geom type="capsule" fromto="0 0 0 0 0 -0.2" size="0.02" mass="0.1"/></body>
    <body name="right" pos="0 -0.05 0"><joint name="r" axis="1 0 0"/>
      <geom name="shin" type="capsule" fromto="0 0 0 0 0 -0.2" size="0.02" mass="0.1"/>
      <body name="toe" pos="0 0 -0.2"><joint name="t" axis="1 0 0"/>
        <geom name="nail" type="sphere" size="0.02" pos="0 0.02 0.19" mass="0.01"/></body></body>
  </body></worldbody>
  <keyframe><key name="home" qpos="0 0 1 1 0 0 0 0 0 0"/></keyframe></mujoco>)";

std::vector<HomeTouch> touches(const std::string& before, const std::string& after) {
  return new_home_touches(*compile_mjcf(before, "a.xml"), *compile_mjcf(after, "a.xml"), "a.xml");
}

std::string with_pose(const std::string& left_and_right) {
  return test::with(kPair, "qpos=\"0 0 1 1 0 0 0 0 0 0\"",
                    "qpos=\"0 0 1 1 0 0 0 " + left_and_right + " 0\"");
}

TEST(HomeTouches, NameLegsThatCameTogether) {
  const auto found = touches(kPair, with_pose("-0.2 0.2"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, "a capsule of 'left'");
  EXPECT_EQ(found[0].second, "geom 'shin' of 'right'");
  EXPECT_NEAR(found[0].depth, 0.04 - 0.1 + 2 * 0.2 * std::sin(0.2), 1e-6);
  EXPECT_EQ(describe(found),
            "in its home pose the designed body touches itself where the initial one does not: a "
            "capsule of 'left' and geom 'shin' of 'right', 19 mm deep; narrow the bounds of what "
            "brought them together ([design.bounds] of the task)");
}

/// Neither what stays clear, nor what touched before, nor the world.
TEST(HomeTouches, AreThoseOfTheDesignAlone) {
  EXPECT_TRUE(touches(kPair, kPair).empty());
  EXPECT_TRUE(touches(kPair, with_pose("0.2 -0.2")).empty());
  EXPECT_TRUE(touches(with_pose("-0.2 0.2"), with_pose("-0.21 0.21")).empty());
  EXPECT_EQ(describe({}), "");
  // The nail touches the trunk already; without that it would be told.
  const std::string without = test::with(kPair, "pos=\"0 0.02 0.19\"", "pos=\"0 0.02 0.1\"");
  ASSERT_EQ(touches(without, kPair).size(), 1u);
  EXPECT_EQ(touches(without, kPair)[0].second, "geom 'nail' of 'toe'");
}

}  // namespace
}  // namespace legwright
