// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/beside_feet.hpp"

#include <gtest/gtest.h>

#include "mjcf/read/read_robot.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

/// Remarks on the puppy with one more geom on its front left foot.
std::vector<std::string> with_geom(const std::string& geom) {
  const std::string joint = "<joint name=\"FL_ankle\" axis=\"0 1 0\"/>";
  return beside_feet(
      parse_robot(test::with(test::named_robot("puppy"), joint, joint + geom), "puppy.xml"));
}

TEST(BesideFeet, RobotsThatTouchWithTheirFeetAloneAreFine) {
  for (const char* name : {"puppy", "hexapod", "quadruped"})
    EXPECT_TRUE(beside_feet(parse_robot(test::named_robot(name), "robot.xml")).empty()) << name;
}

TEST(BesideFeet, AHeelAsLowAsTheFootIsTold) {
  const auto remarks = with_geom(
      R"(<geom name="heel" type="sphere" size="0.008" pos="-0.08 0 -0.081" contype="1"/>)");
  ASSERT_EQ(remarks.size(), 1U);
  for (const char* part : {"geom 'heel'", "0.0807 m from it", "mm higher", "home keyframe"})
    EXPECT_NE(remarks[0].find(part), std::string::npos) << remarks[0];
}

TEST(BesideFeet, ThoseOfAllFeetAreToldInOneSentence) {
  std::string puppy = test::named_robot("puppy");
  for (const char* foot : {"FL", "FR", "HL", "HR"}) {
    const std::string joint = std::string("<joint name=\"") + foot + "_ankle\" axis=\"0 1 0\"/>";
    puppy = test::with(puppy, joint,
                       joint +
                           "<geom type=\"sphere\" size=\"0.008\" pos=\"-0.08 0 -0.081\" "
                           "contype=\"1\"/>");
  }
  const auto remarks = beside_feet(parse_robot(puppy, "puppy.xml"));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("foot 'FL'"), std::string::npos) << remarks[0];
  EXPECT_NE(remarks[0].find(", and so beside foot 'FR', "), std::string::npos) << remarks[0];
}

TEST(BesideFeet, ARodWithOneEndInTheFootAndTheOtherLowIsTold) {
  const auto remarks = with_geom(
      R"(<geom type="capsule" size="0.01" fromto="0 0 -0.07 -0.06 0 -0.077" contype="1"/>)");
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("a geom of body 'FL_foot'"), std::string::npos) << remarks[0];
}

TEST(BesideFeet, WhatIsHigherOrDoesNotCollideIsNot) {
  EXPECT_TRUE(
      with_geom(R"(<geom type="sphere" size="0.008" pos="-0.08 0 -0.07" contype="1"/>)").empty());
  EXPECT_TRUE(
      with_geom(R"(<geom type="capsule" size="0.011" fromto="0 0 -0.07 0 0 0" contype="1"/>)")
          .empty());
  EXPECT_TRUE(with_geom(R"(<geom type="sphere" size="0.008" pos="-0.08 0 -0.081" contype="0"
                           conaffinity="0"/>)")
                  .empty());
}

}  // namespace
}  // namespace legwright
