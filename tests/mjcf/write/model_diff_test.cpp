// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/model_diff.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

const char* const kArm = R"(<mujoco><compiler angle="radian"/><worldbody>
  <body name="arm" pos="0 0 1"><joint name="hinge" axis="0 1 0"/>
    <geom type="sphere" size="0.1" mass="2"/><geom name="tip" type="sphere" size="0.05" pos="0 0 -1" mass="1"/>
    <site name="end" pos="0 0 -1"/></body></worldbody>
  <actuator><position name="servo" joint="hinge" kp="10" forcerange="-3 3"/></actuator></mujoco>)";

std::vector<Difference> differences(const std::string& changed, double tolerance = 1e-9) {
  return model_differences(*compile_mjcf(kArm, "a.xml"), *compile_mjcf(changed, "b.xml"),
                           tolerance);
}

const Difference* find(const std::vector<Difference>& found, const std::string& element,
                       const std::string& quantity) {
  for (const Difference& d : found)
    if (d.element == element && d.quantity == quantity) return &d;
  return nullptr;
}

TEST(ModelDiff, FindsNothingBetweenEqualModels) {
  EXPECT_TRUE(differences(kArm).empty());
  // Other words for the same thing.
  EXPECT_TRUE(differences(test::with(kArm, "axis=\"0 1 0\"", "axis=\"0 2 0\"")).empty());
}

TEST(ModelDiff, TellsLengthsAnglesAndMasses) {
  const auto moved = differences(test::with(kArm, "<site name=\"end\" pos=\"0 0 -1\"/>",
                                            "<site name=\"end\" pos=\"0 0 -1.25\"/>"));
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_EQ(moved[0].element, "site 'end'");
  EXPECT_EQ(moved[0].unit, "m");
  EXPECT_NEAR(moved[0].size, 0.25, 1e-12);

  const auto rotated = differences(test::with(kArm, "axis=\"0 1 0\"", "axis=\"0 1 1\""));
  ASSERT_EQ(rotated.size(), 1u);
  EXPECT_EQ(rotated[0].element, "joint 'hinge'");
  EXPECT_NEAR(rotated[0].size, std::numbers::pi / 4, 1e-12);

  const auto heavier = differences(test::with(kArm, "mass=\"2\"", "mass=\"3\""));
  const Difference* mass = find(heavier, "body 'arm'", "mass");
  ASSERT_NE(mass, nullptr);
  EXPECT_EQ(mass->before, std::vector<double>{3});
  EXPECT_EQ(mass->after, std::vector<double>{4});

  EXPECT_NE(find(differences(test::with(kArm, "-3 3", "-4 4")), "actuator 'servo'", "force range"),
            nullptr);
  EXPECT_NE(
      find(differences(test::with(kArm, "size=\"0.1\"", "size=\"0.2\"")), "geom 'arm#1'", "size"),
      nullptr);
}

TEST(ModelDiff, SeesEveryColumn) {
  struct Change {
    const char *from, *to, *element, *quantity;
  };
  const Change changes[] = {
      {"<joint name=\"hinge\"", "<joint name=\"hinge\" type=\"slide\"", "joint 'hinge'", "type"},
      {"<joint name=\"hinge\"", "<joint name=\"hinge\" damping=\"1\"", "joint 'hinge'", "damping"},
      {"<joint name=\"hinge\"", "<joint name=\"hinge\" armature=\"1\"", "joint 'hinge'",
       "armature"},
      {"<joint name=\"hinge\"", "<joint name=\"hinge\" frictionloss=\"1\"", "joint 'hinge'",
       "friction loss"},
      {"<joint name=\"hinge\"", "<joint name=\"hinge\" stiffness=\"1\"", "joint 'hinge'",
       "stiffness"},
      {"<joint name=\"hinge\"", "<joint name=\"hinge\" range=\"-1 1\"", "joint 'hinge'", "range"},
      {"<joint name=\"hinge\"", "<joint name=\"hinge\" actuatorfrcrange=\"-1 1\"", "joint 'hinge'",
       "torque range"},
      {"<geom name=\"tip\"", "<geom name=\"tip\" friction=\"0.3\"", "geom 'tip'", "friction"},
      {"<geom name=\"tip\"", "<geom name=\"tip\" contype=\"2\"", "geom 'tip'", "collides with"},
      {"<geom name=\"tip\" type=\"sphere\" size=\"0.05\"",
       "<geom name=\"tip\" type=\"box\" size=\"0.05 0.05 0.05\"", "geom 'tip'", "type"},
      {"joint=\"hinge\" kp", "joint=\"hinge\" gear=\"2\" kp", "actuator 'servo'", "gear"},
      {"kp=\"10\"", "kp=\"11\"", "actuator 'servo'", "gain"},
      {"kp=\"10\"", "kp=\"11\"", "actuator 'servo'", "bias"},
      {"</actuator>", "</actuator><keyframe><key name=\"k\" qpos=\"1\"/></keyframe>", "key 'k'",
       "only in B"},
      {"</body></worldbody>", "</body><body name=\"more\"/></worldbody>", "body 'more'",
       "only in B"},
  };
  for (const Change& change : changes)
    EXPECT_NE(find(differences(test::with(kArm, change.from, change.to)), change.element,
                   change.quantity),
              nullptr)
        << change.element << " " << change.quantity;
}

TEST(ModelDiff, SeesABodyThatHangsElsewhere) {
  const std::string two = test::with(kArm, "</body></worldbody>",
                                     "</body><body name=\"b\"/><body name=\"c\"/></worldbody>"),
                    nested =
                        test::with(kArm, "</body></worldbody>",
                                   "</body><body name=\"b\"><body name=\"c\"/></body></worldbody>");
  const auto found = model_differences(*compile_mjcf(two, "a.xml"), *compile_mjcf(nested, "b.xml"));
  EXPECT_NE(find(found, "body 'c'", "hangs on 'world', then on 'b'"), nullptr);
}

TEST(ModelDiff, TellsWhatOnlyOneHas) {
  const auto renamed = differences(test::with(kArm, "name=\"tip\"", "name=\"top\""));
  EXPECT_NE(find(renamed, "geom 'tip'", "only in A"), nullptr);
  EXPECT_NE(find(renamed, "geom 'top'", "only in B"), nullptr);
}

/// A value that is declared otherwise need not change anything else.
TEST(ModelDiff, TellsDeclaredParameters) {
  const std::string one =
      test::with(kArm, "</mujoco>",
                 "<custom><numeric name=\"legwright/long\" data=\"1 0.5 2\"/>"
                 "<text name=\"legwright/long\" data=\"m | stretch link: arm | Length.\"/>"
                 "<numeric name=\"other\" data=\"1\"/></custom></mujoco>");
  const auto between = [&](const std::string& a, const std::string& b) {
    return model_differences(*compile_mjcf(a, "a.xml"), *compile_mjcf(b, "b.xml"));
  };
  EXPECT_TRUE(between(one, one).empty());
  const auto value = between(one, test::with(one, "\"1 0.5 2\"", "\"1.25 0.5 2\""));
  ASSERT_EQ(value.size(), 1u);
  EXPECT_EQ(value[0].element, "parameter 'long'");
  EXPECT_EQ(value[0].quantity, "value");
  EXPECT_EQ(value[0].unit, "m");
  EXPECT_EQ(value[0].after, std::vector<double>{1.25});
  EXPECT_EQ(value[0].size, 0.25);
  const auto bounds = between(one, test::with(one, "\"1 0.5 2\"", "\"1 0.5 3\""));
  ASSERT_EQ(bounds.size(), 1u);
  EXPECT_EQ(bounds[0].quantity, "bounds");
  EXPECT_EQ(bounds[0].before, (std::vector<double>{0.5, 2}));
  const auto binding = between(one, test::with(one, "stretch link: arm", "stretch z: arm"));
  ASSERT_EQ(binding.size(), 1u);
  EXPECT_EQ(binding[0].quantity, "is 'm | stretch link: arm', then 'm | stretch z: arm'");
  EXPECT_TRUE(binding[0].whole());
  // The sentence is for people, and other numbers are not ours.
  EXPECT_TRUE(between(one, test::with(one, "Length.", "How long.")).empty());
  EXPECT_TRUE(
      between(one, test::with(one, "name=\"other\" data=\"1\"", "name=\"other\" data=\"2\""))
          .empty());
  EXPECT_NE(find(between(one, kArm), "parameter 'long'", "only in A"), nullptr);
  EXPECT_NE(find(between(kArm, one), "parameter 'long'", "only in B"), nullptr);
}

TEST(ModelDiff, ListsNothingBelowItsTolerance) {
  const std::string moved = test::with(kArm, "<site name=\"end\" pos=\"0 0 -1\"/>",
                                       "<site name=\"end\" pos=\"0 0 -1.001\"/>");
  EXPECT_EQ(differences(moved).size(), 1u);
  EXPECT_TRUE(differences(moved, 0.01).empty());
}

/// Ends of a tape measure: rounding of a large or small number is none, the same step of a small
/// one is a change.
TEST(ModelDiff, KnowsRoundingErrors) {
  const auto differs = [](const char* unit, double before, double after) {
    Difference d{"body 'a'", "mass", unit, {before}, {after}, std::abs(after - before)};
    return !is_dust(d, 1e-9);
  };
  EXPECT_FALSE(differs("m", 0.0, 1e-17));
  EXPECT_FALSE(differs("m", 0.2, 0.2 + 1e-10));
  EXPECT_TRUE(differs("m", 0.2, 0.2 + 1e-8));
  EXPECT_FALSE(differs("N m/rad or N/m", 24000.0, 24000.0 + 1e-6));
  EXPECT_TRUE(differs("N m/rad or N/m", 24.0, 24.0 + 1e-6));
  EXPECT_FALSE(differs("kg m²", 2e-6, 2e-6 + 1e-16));
  EXPECT_TRUE(differs("kg m²", 2e-6, 2.0005e-6));
  EXPECT_TRUE(differs("kg", 1.0, std::nan("")));
  EXPECT_FALSE(is_dust({"body 'a'", "only in A", "", {}, {}, 0.0}, 1e-9));
}

TEST(ModelDiff, ADesignDiffersWhereItsParameterPoints) {
  const RobotModel puppy = parse_robot(test::named_robot("puppy"), "puppy.xml");
  Eigen::VectorXd s = puppy.space.initial();
  for (int k = 0; k < puppy.space.size(); ++k)
    if (puppy.space.parameters[k].name == "front_shank_length") s[k] += 0.01;
  const auto found = model_differences(*compile_mjcf(puppy.xml, "a.xml"),
                                       *compile_mjcf(rewrite_robot(puppy, s), "b.xml"));
  const Difference* ankle = find(found, "body 'FL_foot'", "place");
  ASSERT_NE(ankle, nullptr);
  EXPECT_NEAR(ankle->size, 0.01, 1e-9);
  EXPECT_EQ(find(found, "body 'HL_foot'", "place"), nullptr);
}

}  // namespace
}  // namespace legwright
