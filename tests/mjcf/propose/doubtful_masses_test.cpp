// SPDX-License-Identifier: Apache-2.0
// Masses in another frame or unit than the shapes, as CAD programs export them.
#include "mjcf/propose/doubtful_masses.hpp"

#include <gtest/gtest.h>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

std::vector<std::string> doubts_of(const std::string& xml) {
  return doubtful_masses(parse_robot(xml, "robot.xml"));
}

std::string dog() { return test::read_file(test::source_path("tests/robots/servo_dog/robot.xml")); }

TEST(DoubtfulMasses, OfRobotsAsTheyAreThereAreNone) {
  for (const char* name : {"courser", "goat", "mule", "octopod", "ox", "porter", "servo_dog"})
    EXPECT_TRUE(doubtful_masses(read_robot(test::source_path(std::string("tests/robots/") + name +
                                                             "/robot.xml")))
                    .empty())
        << name;
  for (const char* name : {"puppy", "piston_puppy"})
    EXPECT_TRUE(doubts_of(test::named_robot(name)).empty()) << name;
}

TEST(DoubtfulMasses, ACentreFarFromTheShapeIsTold) {
  const auto doubts = doubts_of(test::with(dog(), "<inertial pos=\"0 0 0.005\" mass=\"1.15\"",
                                           "<inertial pos=\"0 0.7 0.005\" mass=\"1.15\""));
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_NE(doubts[0].find("body 'frame' is 0.7 m from the middle of its shape"), std::string::npos)
      << doubts[0];
}

TEST(DoubtfulMasses, ACentreBesideAllOfTheShapeIsToldOfARobotThatIsRefused) {
  const std::string beside = test::with(dog(), "<inertial pos=\"0 0 0.005\" mass=\"1.15\"",
                                        "<inertial pos=\"0 0.3 0.005\" mass=\"1.15\"");
  EXPECT_EQ(doubts_of(beside).size(), 1u);
  const std::string footless = test::with(beside, "class=\"ball\" pos",
                                          "class=\"ball\" contype=\"0\" conaffinity=\"0\" pos");
  EXPECT_THROW(parse_robot(footless, "robot.xml"), InputError);
  EXPECT_EQ(doubtful_masses(RobotFiles::from_text(footless, "robot.xml")), doubts_of(beside));
  EXPECT_TRUE(doubtful_masses(RobotFiles::from_text(dog(), "robot.xml")).empty());
}

TEST(DoubtfulMasses, MomentsInGramsAndMillimetresAreTold) {
  const auto doubts =
      doubts_of(test::with(dog(), "diaginertia=\"0.00101583 0.00407292 0.00460958\"",
                           "diaginertia=\"1015.83 4072.92 4609.58\""));
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_NE(doubts[0].find("body 'frame' are those of 1.15 kg at 63 m from its centre"),
            std::string::npos)
      << doubts[0];
}

}  // namespace
}  // namespace legwright
