// SPDX-License-Identifier: Apache-2.0
// Lengths in millimetres, masses in grams, ranges in degrees, as people write them.
#include "mjcf/propose/doubtful_units.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "mjcf/read/read_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

std::vector<std::string> doubts(const RobotModel& robot) {
  return doubtful_units(robot, find_limbs(robot.morphology, robot.space.initial()));
}

/// Servo dog of tests/robots with each number of an attribute times a factor.
RobotModel dog(const char* attribute, double factor) {
  const std::string xml = test::read_file(test::source_path("tests/robots/servo_dog/robot.xml"));
  const std::regex numbers(std::string(" ") + attribute + "=\"([^\"]*)\"");
  std::string out;
  auto rest = xml.cbegin();
  for (std::sregex_iterator at(xml.begin(), xml.end(), numbers), end; at != end; ++at) {
    out.append(rest, (*at)[1].first);
    std::istringstream words((*at)[1].str());
    for (double number = 0.0; words >> number;) out += std::to_string(number * factor) + " ";
    rest = (*at)[1].second;
  }
  return parse_robot(out.append(rest, xml.cend()), "dog.xml");
}

TEST(DoubtfulUnits, OfRobotsAsTheyAreThereAreNone) {
  for (const auto& file : test::taken_robots()) {
    if (file.parent_path().filename() == "lurcher") continue;  // has no pose to be read in
    EXPECT_TRUE(doubts(read_robot(file)).empty()) << file;
  }
  EXPECT_TRUE(doubts(dog("range", 1.0)).empty());
}

TEST(DoubtfulUnits, RangesOfManyTurnsAreTold) {
  const auto found = doubts(dog("range", 57.3));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("joint 'FL_shoulder', as of 7 more, goes to 91.68 rad"),
            std::string::npos)
      << found[0];
}

TEST(DoubtfulUnits, RangesOfFilesInDegreesAreToldInDegrees) {
  RobotModel robot = dog("range", 57.3);
  robot.in_degrees = true;
  const auto found = doubts(robot);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("goes to 5253 degrees, 15 turns: no leg turns so far"), std::string::npos)
      << found[0];
  EXPECT_EQ(found[0].find("rad"), std::string::npos) << found[0];
}

TEST(DoubtfulUnits, MassesInGramsAreTold) {
  const auto found = doubts(dog("mass", 1000.0));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("masses seem to be in grams"), std::string::npos) << found[0];
}

TEST(DoubtfulUnits, LengthsInMillimetresAreTold) {
  const auto found = doubts(dog("pos", 1000.0));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("seem to be in millimetres"), std::string::npos) << found[0];
}

/// As where an exporter wrote the same <limit effort> for every joint.
TEST(DoubtfulUnits, TorquesOfAPlaceholderAreTold) {
  const std::string text = test::read_file(test::source_path("tests/robots/servo_dog/robot.xml"));
  RobotModel robot = parse_robot(text, "dog.xml");
  const double carries = carrying_torque(robot.morphology);
  for (Servo& servo : robot.servos) servo.torque_limit = 19.0 * carries;
  EXPECT_TRUE(doubts(robot).empty());
  robot.servos[1].torque_limit = 100.0;
  const auto found = doubts(robot);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("torque limits of 100 N m (" + robot.servos[1].joint + ")"),
            std::string::npos)
      << found[0];
}

/// Not all lengths, but those of one bone.
TEST(DoubtfulUnits, OneLinkOfAnotherUnitIsNamed) {
  const std::string xml = test::read_file(test::source_path("tests/robots/servo_dog/robot.xml"));
  const std::string bone = "<geom class=\"bone\" fromto=\"0 0 0 0 0 -0.08\"/>";
  for (const auto& [length, words] : {std::pair("-80", "millimetres; multiply that by 0.001"),
                                      std::pair("-8.0", "centimetres; multiply that by 0.01")}) {
    const std::vector<std::string> told = doubts(parse_robot(
        test::with(xml, bone,
                   "<geom class=\"bone\" fromto=\"0 0 0 0 0 " + std::string(length) + "\"/>"),
        "dog.xml"));
    ASSERT_FALSE(told.empty()) << length;
    EXPECT_NE(told[0].find("link 'FL_lower' is 8"), std::string::npos) << told[0];
    EXPECT_NE(told[0].find("(FR_lower, HL_lower, HR_lower)"), std::string::npos) << told[0];
    EXPECT_NE(told[0].find(words), std::string::npos) << told[0];
    for (const std::string& each : told)
      EXPECT_EQ(each.find("multiply them"), std::string::npos) << each;
  }
}

}  // namespace
}  // namespace legwright
