// SPDX-License-Identifier: Apache-2.0
// Robots that are refused: all that is wrong in one list, in the order of the file.
#include "mjcf/text/refusals.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/mesh_quadruped.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

using test::error_message;
using test::holds;

TEST(Refusals, SurroundingsAreNoFaultAndHideNone) {
  std::string xml = test::hopper_with("<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/>");
  xml = test::with(xml, "<worldbody>",
                   "<option gravity=\"0 0 -9.8\"/><worldbody>"
                   "<geom name=\"floor\" type=\"plane\" size=\"0 0 1\"/>");
  const std::string all = error_message(xml);
  EXPECT_TRUE(holds(all, "attribute gravity: 0 0 -9.8")) << all;
  EXPECT_FALSE(holds(all, "floor")) << all;
  EXPECT_EQ(error_message(test::with(xml, "0 0 -9.8\"", "0 0 -9.81\"")), "");
  EXPECT_TRUE(holds(error_message(test::with(xml, "-9.8\"", "-981\"")), "in centimetres"));
  EXPECT_TRUE(holds(error_message(test::with(xml, "-9.8\"", "-9810\"")), "in millimetres"));
  EXPECT_FALSE(holds(error_message(test::with(xml, "-9.8\"", "-1.62\"")), "metres"));
}

TEST(Refusals, AllFaultsOfTheTextAreToldInTheOrderOfTheFile) {
  std::string xml = test::hopper_with("<geom name=\"tip\" size=\"0,02\" pos=\"0 0 nan\"/>");
  xml = test::with(xml, "<worldbody>", "<compiler fusestatic=\"true\"/><worldbody>");
  xml = test::with(xml, "<joint name=\"knee\" axis=\"0 1 0\"/>",
                   "<site name=\"a\" pos=\"0 0 1e999\"/><joint name=\"knee\" axis=\"0 0 0\"/>");
  const std::string all = error_message(xml);
  std::size_t at = 0;
  for (const char* part : {"attribute fusestatic", "1e999", "a zero axis", "0,02", "'nan'"}) {
    const std::size_t found = all.find(part);
    ASSERT_NE(found, std::string::npos) << part << " not in " << all;
    EXPECT_GE(found, at) << all;
    at = found;
  }
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 4) << all;
}

/// Of the text, of the structure and of declarations: no second list after the first is mended.
TEST(Refusals, FaultsOfAllKindsAreToldInOneList) {
  std::string xml = test::named_robot("puppy");
  const std::size_t data = xml.find("_length\" data=\"") + 15;
  xml.insert(data, "9");  // a length that is none of the robot's
  const std::size_t text = xml.rfind("| axis ");
  ASSERT_NE(text, std::string::npos);
  xml.replace(text, 7, "| turn ");
  const std::size_t last = xml.rfind("<joint ", xml.find("</worldbody>"));
  xml.insert(last + 7, "type=\"slide\" ");
  xml =
      test::with(xml, "<inertial pos=\"0 0 0\" mass=\"1\"", "<inertial pos=\"0 0 0\" mass=\"1,0\"");
  const std::string all = error_message(xml);
  for (const char* part : {"'1,0' is not a number", "slide joints", "binding 'turn' is unknown"})
    EXPECT_TRUE(holds(all, part)) << part << " not in:\n" << all;
}

/// Of what has no name, and where MuJoCo tells none itself.
TEST(Refusals, HaveALineWhereTheElementIsKnown) {
  const std::string good = test::hopper_with("<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/>");
  const auto line_of = [](const std::string& told) {
    return std::string(told).substr(0, told.find(": "));
  };
  EXPECT_NE(
      line_of(error_message(test::with(good, "<body name=\"thigh\">", "<body gravcomp=\"1\">"))),
      "robot.xml");
  EXPECT_NE(line_of(error_message(test::with(good, "<joint name=\"knee\"", "<joint"))),
            "robot.xml");
  EXPECT_NE(line_of(error_message(test::with(good, "qpos=\"0 0 0.5", "qpos=\"0 0 0 0.5"))),
            "robot.xml");
  EXPECT_NE(line_of(error_message(test::with(good, "name=\"trunk\"", ""))), "robot.xml");
}

TEST(Refusals, AllActuatorsThatAreNoServosAreToldAtOnceMusclesAsOne) {
  std::string xml = test::with(test::named_robot("puppy"), "<freejoint name=\"root\"/>",
                               "<freejoint name=\"root\"/><site name=\"eye\"/>");
  const auto replaced = [&](const std::string& joint, const std::string& by) {
    const std::size_t at = xml.rfind("<position", xml.find("joint=\"" + joint + "\""));
    ASSERT_NE(at, std::string::npos);
    xml.replace(at, xml.find("/>", at) + 2 - at, by);
  };
  replaced("FL_hip", "<muscle joint=\"FL_hip\" ctrllimited=\"true\" ctrlrange=\"0 1\"/>");
  replaced("FL_knee", "<muscle joint=\"FL_knee\" ctrllimited=\"true\" ctrlrange=\"0 1\"/>");
  replaced("FL_ankle", "<motor site=\"eye\"/><position joint=\"FR_hip\" kp=\"1\"/>");
  const std::string all = error_message(xml);
  for (const char* part : {"is a muscle, and so are 1 more", "drives no hinge", "second actuator",
                           "'FL_ankle': has no actuator"})
    EXPECT_TRUE(holds(all, part)) << part << " not in:\n" << all;
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 3) << all;
}

TEST(Refusals, MeshesInMillimetresAreToldOnce) {
  const std::string told = error_message(
      test::with(test::mesh_quadruped(), "scale=\"0.001 0.001 0.001\"", "scale=\"1 1 1\""));
  EXPECT_TRUE(holds(told, "m wide; where meshes are in millimetres, each needs scale=")) << told;
  EXPECT_EQ(told.find("in millimetres"), told.rfind("in millimetres")) << told;
}

TEST(Refusals, AllDeclarationsThatNoLongerMeasureAreToldAtOnce) {
  const std::string xml = test::named_robot("puppy");
  std::string all = xml;
  int changed = 0;
  for (std::size_t at = 0; (at = all.find("_length\" data=\"0.", at)) != std::string::npos;) {
    at = all.find("0.", at);
    all.replace(at, 2, "9.");
    ++changed;
  }
  ASSERT_GT(changed, 1);
  const std::string told = error_message(all);
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), changed - 1) << told;
}

TEST(Refusals, AllReasonsAreReportedAtOnceEachWithItsLine) {
  std::string xml = test::hopper_with("<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/>");
  xml = test::with(xml, "<joint name=\"knee\" axis=\"0 1 0\"/>",
                   "<joint name=\"knee\" axis=\"0 1 0\" type=\"slide\"/>");
  xml = test::with(xml, "<body name=\"thigh\">", "<body name=\"thigh\" gravcomp=\"1\">");
  xml = test::with(xml, "  </worldbody>",
                   "    <body name=\"ball\"><freejoint/><geom size=\"0.1\"/><body name=\"lid\">"
                   "<joint/><geom size=\"0.1\"/></body></body>\n"
                   "  </worldbody>");
  xml = test::with(xml, "  <keyframe><key name=\"home\" qpos=\"0 0 0.5 1 0 0 0 0 0\"/></keyframe>",
                   "  <equality><weld name=\"w\" body1=\"shank\" body2=\"trunk\"/></equality>");
  const std::string all = error_message(xml);
  for (const char* part :
       {"robot.xml:11: body 'thigh': attribute gravcomp", "joint 'knee': slide joints",
        "body 'ball': a second free root with joints", "weld 'w': closes a loop"})
    EXPECT_TRUE(holds(all, part)) << part << " not in:\n" << all;
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 3) << all;
}

}  // namespace
}  // namespace legwright
