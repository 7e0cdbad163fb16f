// SPDX-License-Identifier: Apache-2.0
// One list of all faults, whatever stage of the reading finds them: no second list after the first
// is mended.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/assembly/boxy_dog.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

/// What is wrong somewhere: one piece of text for another, and what is told of it.
struct StageFault {
  std::string from, to, told;
};

/// The robot with all faults in it, each told on a line of its own, in the order of the file, and
/// nothing else.
void expect_one_list(std::string xml, const std::vector<StageFault>& faults) {
  ASSERT_EQ(test::error_message(xml), "");
  for (const StageFault& fault : faults) xml = test::with(xml, fault.from, fault.to);
  try {
    parse_robot(xml, "robot.xml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string all = error.what();
    for (const StageFault& fault : faults)
      EXPECT_TRUE(test::holds(all, fault.told)) << fault.told << " not in:\n" << all;
    EXPECT_EQ(error.reasons().size(), faults.size()) << all;
    int before = 0;
    for (const InputError& reason : error.reasons()) {
      EXPECT_GE(reason.line(), std::max(1, before)) << reason.what();
      before = reason.line();
    }
  }
}

TEST(OneList, OfAllStages) {
  const auto declared = [](const std::string& name, const std::string& numbers,
                           const std::string& words) {
    return "<numeric name=\"legwright/" + name + "\" data=\"" + numbers +
           "\"/>\n<text name=\"legwright/" + name + "\" data=\"" + words + "\"/>\n";
  };
  const std::string xml = build_robot(test::hulled_dog(), "dog.xml").xml;
  expect_one_list(
      xml,
      {{"<joint name=\"FL_hip\" axis=\"0 1 0\" range=\"-2.5 2.5\"",
        "<joint name=\"FL_hip\" axis=\"0 1 0\" range=\"2 2.5\"", "'FL_hip': the home pose has"},
       {"<joint name=\"HR_knee\" axis=\"0 1 0\" range=\"-2.5 2.5\"",
        "<joint name=\"HR_knee\" axis=\"0 1 0\" range=\"2 2.5\"", "'HR_knee': the home pose has"},
       {"<body name=\"FR_hip_link\" pos=\"0.09 -0.07 0\">",
        "<body name=\"FR_hip_link\" pos=\"0.09 -0.07 0\">\n<geom type=\"ellipsoid\" density=\"9\" "
        "size=\"0.01 0.01 0.01\" fromto=\"0 0 0 0 0 0.01\"/>",
        "an ellipsoid placed by fromto"},
       {"<position name=\"FR_hip_servo\"", "<position name=\"FR_hip_servo\" gear=\"0\"",
        "attribute gear"},
       {"joint=\"HL_hip\" kp", "joint=\"HL_knee\" kp", "second actuator of joint 'HL_knee'"},
       {"<joint name=\"HL_hip\"", "<joint name=\"HL_hip\" frictionloss=\"0\"",
        "'HL_hip': has no actuator"},
       {"<custom>",
        "<custom>\n" +
            declared("again", "0.09 0.08 0.1", "m | stretch z: FL_hip_link | Once more."),
        "already stretched along nearly this direction by"},
       {"<custom>",
        "<custom>\n" + declared("off", "9 8 10", "m | stretch link: HL_knee_link | Off."),
        "declares 9 m, but body 'HL_knee_link' measures"},
       {"<custom>", "<custom>\n<text name=\"legwright_turns/tail\" data=\"joint FL_hip\"/>",
        "declares the body 'tail'"},
       {"<custom>", "<custom>\n<text name=\"legwright_turns/head\" data=\"joint FL_hip\"/>",
        "declares the body 'head'"},
       {"name=\"legwright_connector/FL_knee_link_arm\" data=\"1240",
        "name=\"legwright_connector/FL_knee_link_arm\" data=\"-1240", "is no density"},
       {"name=\"legwright_connector/HL_knee_link_arm\" data=\"1240",
        "name=\"legwright_connector/HL_knee_link_arm\" data=\"-1240", "is no density"},
       {"<custom>", "<custom>\n<numeric name=\"legwright_motor/tail\" data=\"1 1\"/>",
        "is the motor of joint 'tail'"},
       {"<custom>", "<custom>\n<numeric name=\"legwright_motor/HL_hip\" data=\"1\"/>",
        "is no motor"}});
}

/// Of the text, and what MuJoCo reads behind it.
TEST(OneList, OfAllStagesBehindATextThatIsNotRead) {
  expect_one_list(
      build_robot(test::hulled_dog(), "dog.xml").xml,
      {{"<joint name=\"FL_hip\" axis=\"0 1 0\" range=\"-2.5 2.5\"",
        "<joint name=\"FL_hip\" axis=\"0 1 0\" range=\"-2 2,5\"", "'2,5' is not a number"},
       {"<joint name=\"HR_knee\" axis=\"0 1 0\" range=\"-2.5 2.5\"",
        "<joint name=\"HR_knee\" axis=\"0 1 0\" range=\"2 2.5\"", "'HR_knee': the home pose has"},
       {"joint=\"HL_hip\" kp", "joint=\"HL_knee\" kp", "second actuator of joint 'HL_knee'"},
       {"<joint name=\"HL_hip\"", "<joint name=\"HL_hip\" frictionloss=\"0\"",
        "'HL_hip': has no actuator"},
       {"name=\"legwright_connector/FL_knee_link_arm\" data=\"1240",
        "name=\"legwright_connector/FL_knee_link_arm\" data=\"-1240", "is no density"}});
}

/// A leg without foot and a joint that slides hide neither home pose nor servos of the others, and
/// nothing is told that only follows from them.
TEST(OneList, OfStructureAndServos) {
  expect_one_list(
      test::with(build_robot(test::hulled_dog(), "dog.xml").xml,
                 "<geom group=\"3\" density=\"0\"/>",
                 "<geom group=\"3\" density=\"0\" contype=\"0\" conaffinity=\"0\"/>"),
      {{"<geom name=\"FL\" class=\"foot\"",
        "<geom name=\"FL\" class=\"foot\" contype=\"0\" conaffinity=\"0\"",
        "ends a leg without a foot"},
       {"<joint name=\"FR_hip\"", "<joint name=\"FR_hip\" type=\"slide\"",
        "'FR_hip': slide joints are not supported"},
       {"<joint name=\"HR_knee\" axis=\"0 1 0\" range=\"-2.5 2.5\"",
        "<joint name=\"HR_knee\" axis=\"0 1 0\" range=\"2 2.5\"", "'HR_knee': the home pose has"},
       {"joint=\"HL_hip\" kp", "joint=\"HL_knee\" kp", "second actuator of joint 'HL_knee'"},
       {"<joint name=\"HL_hip\"", "<joint name=\"HL_hip\" frictionloss=\"0\"",
        "'HL_hip': has no actuator"},
       {"<custom>", "<custom>\n<numeric name=\"legwright_motor/HL_hip\" data=\"1\"/>",
        "is no motor"}});
}

/// The same where linear actuators move joints.
TEST(OneList, OfTendonsAndServos) {
  expect_one_list(
      test::named_robot("piston_puppy"),
      {{"<spatial name=\"FL_piston\"", "<spatial name=\"FL_piston\" width=\"0.002\"",
        "'FL_piston': has no actuator"},
       {"tendon=\"FL_piston\"", "joint=\"FL_hip\"", "second actuator of joint 'FL_hip'"},
       {"tendon=\"HR_piston\"", "tendon=\"HR_piston\" gear=\"0\"", "attribute gear"}});
}

}  // namespace
}  // namespace legwright
