// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/skins.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/scene/played_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

/// The puppy in a coat of one triangle from its trunk to its first shank.
std::string puppy_in_a_coat(const std::string& bones = "") {
  return test::with(test::read_file(test::puppy_file()), "<worldbody>",
                    "<asset><skin name=\"coat\" vertex=\"0 0 0.1 0.1 0 0.1 0 0.1 0\" "
                    "face=\"0 1 2\"><bone body=\"FL_thigh\" bindpos=\"0 0 0\" bindquat=\"1 0 0 0\" "
                    "vertid=\"0 1 2\" vertweight=\"1 1 1\"/>" +
                        bones + "</skin></asset>\n  <worldbody>");
}

/// A design in which one parameter of a unit has another value.
Eigen::VectorXd with_another(const RobotModel& robot, const std::string& unit) {
  Eigen::VectorXd s = robot.space.initial();
  for (int k = 0; k < robot.space.size(); ++k)
    if (robot.space.parameters[k].unit == unit) {
      s[k] = robot.space.parameters[k].upper;
      return s;
    }
  ADD_FAILURE() << "no parameter in " << unit;
  return s;
}

int skin_group(const RobotModel& robot, const Eigen::VectorXd& s) {
  const ModelPointer model = compile_mjcf(rewrite_robot(robot, s), robot.file);
  EXPECT_EQ(model->nskin, 1);
  return model->skin_group[0];
}

TEST(Skins, GoOutOfSightWhereLinksChangeTheirLengthsAndOnlyThere) {
  const RobotModel robot = parse_robot(puppy_in_a_coat(), "puppy.xml");
  EXPECT_EQ(skin_group(robot, robot.space.initial()), 0);
  EXPECT_EQ(skin_group(robot, with_another(robot, "rad")), 0);
  EXPECT_EQ(skin_group(robot, with_another(robot, "m")), 5);
}

TEST(Skins, AreToldWithWhatBecomesOfThem) {
  const std::string coat = describe_skins(*compile_mjcf(puppy_in_a_coat(), "puppy.xml"));
  EXPECT_NE(coat.find("skin 'coat': only to be seen"), std::string::npos) << coat;
  EXPECT_NE(coat.find("group 5, out of sight"), std::string::npos) << coat;
  EXPECT_EQ(describe_skins(*compile_mjcf(test::read_file(test::puppy_file()), "puppy.xml")), "");
}

TEST(Skins, StayInSightWhereNothingElseIsDrawn) {
  std::string xml = puppy_in_a_coat();
  for (std::size_t at = xml.find("<geom "); at != std::string::npos; at = xml.find("<geom ", at)) {
    xml.insert(at + 6, "group=\"3\" ");
    const std::size_t own = xml.find(" group=\"", at + 15), end = xml.find('>', at);
    if (own < end) xml.erase(own, xml.find('"', own + 8) + 1 - own);
    at += 6;
  }
  const RobotModel robot = parse_robot(xml, "puppy.xml");
  EXPECT_EQ(skin_group(robot, with_another(robot, "m")), 0);
  EXPECT_NE(describe_skins(*compile_mjcf(xml, "puppy.xml")).find("so it stays"), std::string::npos);
}

/// A bone on what scenes leave out would name a body that is not there.
TEST(Skins, OverABodyThatMovesByItselfGoWithIt) {
  std::string xml = puppy_in_a_coat(
      "<bone body=\"ball\" bindpos=\"0 0 3\" bindquat=\"1 0 0 0\" vertid=\"2\" "
      "vertweight=\"1\"/>");
  xml = test::with(xml, "<worldbody>",
                   "<worldbody><body name=\"ball\" pos=\"0 0 3\"><freejoint/>"
                   "<geom name=\"ball\" size=\"0.1\" mass=\"1\"/></body>");
  xml.replace(xml.find("qpos=\"") + 6, 0, "0 0 3 1 0 0 0 ");
  const RobotModel robot = parse_robot(xml, "puppy.xml");
  EXPECT_EQ(compile_mjcf(played_robot(robot, robot.xml), robot.file)->nskin, 0);
  const RobotModel dressed = parse_robot(puppy_in_a_coat(), "puppy.xml");
  EXPECT_EQ(compile_mjcf(played_robot(dressed, dressed.xml), dressed.file)->nskin, 1);
}

}  // namespace
}  // namespace legwright
