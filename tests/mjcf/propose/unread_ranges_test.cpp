// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/unread_ranges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mjcf/propose/proposals.hpp"
#include "mjcf/read/read_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

std::string dog_with_range(const std::string& from, const std::string& to) {
  const std::string xml = test::read_file(test::source_path("tests/robots/servo_dog/robot.xml"));
  return from.empty() ? xml : test::with(xml, from, to);
}

TEST(UnreadRanges, OfRobotsAsTheyAreThereAreNone) {
  EXPECT_TRUE(unread_ranges(parse_robot(dog_with_range("", ""), "dog.xml")).empty());
  EXPECT_TRUE(unread_ranges(parse_robot(test::example_robot("puppy"), "puppy.xml")).empty());
}

TEST(UnreadRanges, SwappedAndEqualEndsAreTold) {
  for (const std::string range : {"range=\"0.4 -2.2\"", "range=\"-1 -1\""}) {
    const std::string xml = dog_with_range("range=\"-2.2 0.4\"", range);
    const RobotModel robot = parse_robot(xml, "dog.xml");
    const std::vector<std::string> told = unread_ranges(robot);
    ASSERT_EQ(told.size(), 1u) << range;
    EXPECT_NE(told[0].find("not above the lower one"), std::string::npos) << told[0];
    const std::vector<std::string> remarks = propose_parameters(xml, "dog.xml").remarks;
    EXPECT_NE(std::find(remarks.begin(), remarks.end(), told[0]), remarks.end());
  }
}

}  // namespace
}  // namespace legwright
