// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/home_touches.hpp"

#include <gtest/gtest.h>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/source_tree.hpp"

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

/// The servo dog, whose bones touch nothing, with an upper leg and a trunk that do.
std::string touching_dog(const std::string& trunk_size, const std::string& contact = "") {
  std::string xml = test::read_file(test::source_path("tests/robots/servo_dog/robot.xml"));
  xml = test::with(xml, "<geom class=\"bone\" fromto=\"0 0 0 0 0 -0.08\"/>",
                   "<geom class=\"bone\" fromto=\"0 0 0 0 0 -0.08\" contype=\"1\"/>");
  xml = test::with(xml, "<geom type=\"box\" size=\"0.1 0.045 0.02\"",
                   "<geom name=\"shell\" type=\"box\" contype=\"1\" conaffinity=\"1\" size=\"" +
                       trunk_size + "\"");
  return test::with(xml, "</mujoco>", contact + "</mujoco>");
}

std::vector<std::string> overlaps(const std::string& xml) {
  return overlapping_links(parse_robot(xml, "dog.xml"));
}

TEST(OverlappingLinks, AreToldWithDepthAndCure) {
  EXPECT_TRUE(overlaps(touching_dog("0.1 0.045 0.02")).empty());
  const std::vector<std::string> told = overlaps(touching_dog("0.1 0.066 0.08"));
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0],
            "'FL_lower' is 6 mm inside 'frame' in the home pose (a capsule in geom 'shell'): what "
            "is played pushes them apart, whatever the gait; give them an <exclude "
            "body1=\"frame\" body2=\"FL_lower\"/> in <contact>, or make one smaller");
  EXPECT_TRUE(overlaps(touching_dog("0.1 0.066 0.08",
                                    "<contact><exclude body1=\"frame\" "
                                    "body2=\"FL_lower\"/></contact>"))
                  .empty())
      << "the cure cures";
}

/// A shell beside the whole leg, which no turn of shoulder and knee takes out of it, and one that
/// the knee leaves.
TEST(LastingOverlaps, AreThoseThatNoTurnOfTheirHingesEnds) {
  const auto lasting = [](const std::string& xml) {
    return lasting_overlaps(parse_robot(xml, "dog.xml"));
  };
  EXPECT_TRUE(lasting(touching_dog("0.1 0.045 0.02")).empty());
  EXPECT_FALSE(overlaps(touching_dog("0.1 0.066 0.08")).empty());
  EXPECT_TRUE(lasting(touching_dog("0.1 0.066 0.08")).empty());
  const std::vector<BodyTouch> found = lasting(touching_dog("0.2 0.066 0.13"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, "frame");
  EXPECT_EQ(found[0].second, "FL_lower");
  EXPECT_NEAR(found[0].depth, 0.01, 1e-4);
  EXPECT_EQ(
      excluded_words(found),
      "shapes of one limb overlap wherever its joints turn: 'FL_lower' in 'frame' (10 mm); an "
      "<exclude> in <contact> lets them pass");
}

/// Upper legs hang on the trunk, with which MuJoCo lets them pass; the floor is no link.
TEST(OverlappingLinks, AreThoseThatMujocoCollides) {
  const std::string xml =
      test::with(touching_dog("0.1 0.045 0.02"), "<geom class=\"knee_servo\"",
                 "<geom class=\"knee_servo\" contype=\"1\" conaffinity=\"1\" name=\"servo\"");
  EXPECT_TRUE(
      overlaps(test::with(xml, "size=\"0.1 0.045 0.02\"", "size=\"0.1 0.066 0.02\"")).empty());
  EXPECT_TRUE(
      overlaps(test::with(xml, "<worldbody>",
                          "<worldbody><geom type=\"plane\" size=\"1 1 1\" pos=\"0 0 0.05\"/>"))
          .empty());
}

}  // namespace
}  // namespace legwright
