// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/facing.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mjcf/propose/side_words.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;

struct Hip {
  std::string name;
  double x, y;
};

/// Legs of two joints below hips.
Facing facing(const std::vector<Hip>& hips, const std::string& in_trunk = "",
              const std::string& axis = "0 1 0") {
  std::string legs, servos;
  for (const Hip& hip : hips) {
    legs += fmt::format(
        R"(<body name="{0}_thigh" pos="{1} {2} 0"><joint name="{0}_hip" axis="{3}"/>
        <inertial pos="0 0 -.05" mass=".1" diaginertia="1e-4 1e-4 1e-4"/>
        <body name="{0}_shank" pos="0 0 -.1"><joint name="{0}_knee" axis="{3}"/>
        <inertial pos="0 0 -.05" mass=".1" diaginertia="1e-4 1e-4 1e-4"/>
        <geom size=".01" pos="0 0 -.1"/></body></body>)",
        hip.name, hip.x, hip.y, axis);
    for (const char* joint : {"hip", "knee"})
      servos +=
          fmt::format(R"(<position joint="{}_{}" kp="50" forcerange="-5 5"/>)", hip.name, joint);
  }
  const RobotModel robot = parse_robot(
      R"(<mujoco><compiler angle="radian"/><worldbody><body name="trunk" pos="0 0 .21"><freejoint/>
      <inertial pos="0 0 0" mass="2" diaginertia=".01 .01 .01"/>)" +
          legs + in_trunk + "</body></worldbody><actuator>" + servos + "</actuator></mujoco>",
      "robot.xml");
  return facing_of(robot);
}

std::vector<Hip> turned(std::vector<Hip> hips) {
  for (Hip& hip : hips) std::swap(hip.x, hip.y);
  for (Hip& hip : hips) hip.x = -hip.x;
  return hips;
}

const std::vector<Hip> kDog{{"FL", .2, .1}, {"FR", .2, -.1}, {"RL", -.2, .1}, {"RR", -.2, -.1}};
const std::vector<Hip> kAnt{{"leg1", .2, .1},  {"leg2", 0, .12},  {"leg3", -.2, .1},
                            {"leg4", .2, -.1}, {"leg5", 0, -.12}, {"leg6", -.2, -.1}};

TEST(Facing, IsAheadWhereNothingSpeaksAgainstIt) {
  for (const auto& hips : {kDog, kAnt}) {
    const Facing found = facing(hips);
    EXPECT_EQ(found.ahead, Vector2d(1, 0));
    EXPECT_EQ(found.remark, "");
  }
}

TEST(Facing, FollowsTheNamesOfTheLegs) {
  const Facing left = facing(turned(kDog));
  EXPECT_EQ(left.ahead, Vector2d(0, 1));
  EXPECT_NE(left.remark.find("0.4 m along +y from those that are called hind"), std::string::npos)
      << left.remark;
  EXPECT_EQ(facing(turned(turned(kDog))).ahead, Vector2d(-1, 0));
  EXPECT_EQ(facing(turned(turned(turned(kDog)))).ahead, Vector2d(0, -1));
  // Names of rows that stand askew say nothing.
  EXPECT_EQ(facing({{"FL", .2, .2}, {"FR", .1, .1}, {"RL", -.1, -.1}, {"RR", -.2, -.2}}).remark,
            "");
}

TEST(Facing, FollowsLeftAndRightWhereNoNameTellsFront) {
  const std::vector<Hip> two{{"left", 0, .1}, {"right", 0, -.1}};
  EXPECT_EQ(facing(two).ahead, Vector2d(1, 0));
  const Facing found = facing(turned(two));
  EXPECT_EQ(found.ahead, Vector2d(0, 1));
  EXPECT_NE(found.remark.find("are called left hang 0.2 m along -x"), std::string::npos)
      << found.remark;
  EXPECT_EQ(facing(turned(turned(two))).ahead, Vector2d(-1, 0));
  EXPECT_EQ(facing(turned(turned(turned(two)))).ahead, Vector2d(0, -1));
  // Rows know no sign, names do.
  const std::vector<Hip> ant{{"L1", .2, .1},  {"L2", 0, .12},  {"L3", -.2, .1},
                             {"R1", .2, -.1}, {"R2", 0, -.12}, {"R3", -.2, -.1}};
  EXPECT_EQ(facing(turned(turned(turned(ant)))).ahead, Vector2d(0, -1));
}

TEST(Facing, TwoLegsWithoutNamesStandBesideEachOther) {
  EXPECT_EQ(facing({{"a", 0, .1}, {"b", 0, -.1}}).remark, "");
  const Facing found = facing({{"a", -.1, 0}, {"b", .1, 0}});
  EXPECT_EQ(found.ahead, Vector2d(0, 1));
  EXPECT_NE(found.remark.find("two hips stand 0.2 m apart along x"), std::string::npos)
      << found.remark;
}

TEST(Facing, IsWhereLegsWithoutNamesSwing) {
  const std::vector<Hip> four{{"a", .1, .1}, {"b", .1, -.1}, {"c", -.1, .1}, {"d", -.1, -.1}};
  EXPECT_EQ(facing(four).ahead, Vector2d(1, 0));
  const Facing found = facing(four, "", "1 0 0");
  EXPECT_EQ(found.ahead, Vector2d(0, 1));
  EXPECT_NE(found.remark.find("swing in planes along y"), std::string::npos) << found.remark;
  EXPECT_EQ(facing(kDog, "", "1 0 0").ahead, Vector2d(1, 0)) << "names tell: it walks sideways";
}

TEST(Facing, FollowsTheRowsOfManyLegsWithoutNames) {
  const Facing found = facing(turned(kAnt));
  EXPECT_EQ(found.ahead, Vector2d(0, 1));
  EXPECT_NE(found.remark.find("hips stand in two rows along y, 0.2 m apart"), std::string::npos)
      << found.remark;
  // As long as wide, and round: no leg hangs in front of the trunk.
  EXPECT_EQ(facing({{"a", -.11, .13},
                    {"b", -.11, 0},
                    {"c", -.11, -.13},
                    {"d", .11, .13},
                    {"e", .11, 0},
                    {"f1", .11, -.13}})
                .ahead,
            Vector2d(0, 1));
  EXPECT_EQ(facing({{"a", .2, 0},
                    {"b", .1, .17},
                    {"c", -.1, .17},
                    {"d", -.2, 0},
                    {"e", -.1, -.17},
                    {"g", .1, -.17}})
                .ahead,
            Vector2d(0, 1));
  EXPECT_EQ(facing({{"a", 0, .2},
                    {"b", .17, .1},
                    {"c", .17, -.1},
                    {"d", 0, -.2},
                    {"e", -.17, -.1},
                    {"g", -.17, .1}})
                .remark,
            "");
  std::vector<Hip> four = turned(kDog);  // a wide robot, for all that is known
  for (std::size_t k = 0; k < four.size(); ++k) four[k].name = fmt::format("leg{}", k);
  const Facing wide = facing(four);
  EXPECT_EQ(wide.ahead, Vector2d(1, 0));
  EXPECT_NE(wide.remark.find("0.4 m apart along y and 0.2 m along x"), std::string::npos)
      << wide.remark;
  EXPECT_NE(wide.remark.find("forward = \"+y\""), std::string::npos) << wide.remark;
}

TEST(Facing, FollowsAnEyeWhereNoNameAndNoRowTells) {
  std::vector<Hip> square{{"a", .1, .1}, {"b", .1, -.1}, {"c", -.1, .1}, {"d", -.1, -.1}};
  EXPECT_EQ(facing(square).remark, "");
  // Looks along −z of its own: along +y of the trunk, out of its side.
  const std::string eye = R"(<camera name="eye" pos="0 .1 0" xyaxes="1 0 0 0 0 1"/>)",
                    watcher = R"(<camera name="side" pos="0 -1 0" xyaxes="1 0 0 0 0 1"/>)",
                    other = R"(<camera name="nose" pos=".1 0 0" xyaxes="0 -1 0 0 0 1"/>)";
  const Facing found = facing(square, eye);
  EXPECT_EQ(found.ahead, Vector2d(0, 1));
  EXPECT_NE(found.remark.find("camera 'eye' of its trunk looks along +y"), std::string::npos)
      << found.remark;
  EXPECT_EQ(facing(square, watcher).remark, "") << "looks at the robot from outside";
  EXPECT_EQ(facing(square, eye + other).remark, "") << "two ways";
  EXPECT_EQ(facing(square, other).ahead, Vector2d(1, 0));
  EXPECT_EQ(facing(kDog, eye).ahead, Vector2d(1, 0)) << "names tell";
}

/// Hips in one place, but for what hands leave: their names say nothing of where it looks.
TEST(Facing, CalledRowsAreApart) {
  EXPECT_EQ(
      facing({{"FL", .1, .215}, {"FR", .1, -.185}, {"RL", .1, .185}, {"RR", .1, -.215}}).ahead,
      Vector2d(1, 0));
  EXPECT_EQ(facing({{"FL", .1, .21}, {"FR", .1, .19}, {"RL", .1, -.19}, {"RR", .1, -.21}}).ahead,
            Vector2d(0, 1));
}

TEST(SideWords, TellRows) {
  for (const char* name : {"FL_hip", "hip_front_left", "rf1", "fore-leg", "f"})
    EXPECT_EQ(row_word(name), 1) << name;
  for (const char* name : {"FrontRight_Lower_1", "frontRight", "frontright", "RightFront", "FRleg",
                           "FRLeg", "LegFR", "LFFoot", "FrontLegL"})
    EXPECT_EQ(row_word(name), 1) << name;
  for (const char* name : {"BackLeft2", "LegRL", "RRUpper", "hindleft", "RLthigh"})
    EXPECT_EQ(row_word(name), -1) << name;
  for (const char* name : {"forearm", "Forearm", "RLeg", "LHip", "HipF", "Frontal", "MiddleRight",
                           "backpack", "HAA", "armF"})
    EXPECT_EQ(row_word(name), 0) << name;
  for (const char* name : {"RL_hip", "rear.left", "LH", "hind", "back_2", "h", "bl_1", "br_2"})
    EXPECT_EQ(row_word(name), -1) << name;
  for (const char* name : {"", "hip", "left", "front_hind", "flange", "LM_coxa", "r", "l"})
    EXPECT_EQ(row_word(name), 0) << name;
}

TEST(SideWords, TellSides) {
  for (const char* name :
       {"FL_hip", "hip_left", "LHip", "thighL", "l_ankle", "LM_coxa", "leftKnee"})
    EXPECT_EQ(lateral_word(name), 1) << name;
  for (const char* name : {"FR_hip", "right.hip", "RLeg", "kneeR", "r", "RRUpper", "BackRight2"})
    EXPECT_EQ(lateral_word(name), -1) << name;
  for (const char* name : {"", "hip", "lever", "roll", "left_right", "front"})
    EXPECT_EQ(lateral_word(name), 0) << name;
}

TEST(SideWords, LeaveThePart) {
  for (const char* name :
       {"FL_thigh", "thigh_front_left", "FrontLeft_thigh", "FLthigh", "thighFL", "frontleft_thigh"})
    EXPECT_EQ(without_side(name), "thigh") << name;
  EXPECT_EQ(without_side("FrontLeftUpperLeg"), "UpperLeg");
  EXPECT_EQ(without_side("RightFoot"), "Foot");
  EXPECT_EQ(without_side("FL"), "");
  EXPECT_EQ(without_side("forearm"), "forearm");
}

}  // namespace
}  // namespace legwright
