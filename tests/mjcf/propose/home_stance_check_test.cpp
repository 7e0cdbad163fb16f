// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/home_stance_check.hpp"

#include <gtest/gtest.h>

#include "mjcf/propose/proposals.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/turned_biped.hpp"

namespace legwright {
namespace {

std::string fault(const std::string& xml) {
  return propose_parameters(xml, "robot.xml").not_standing;
}

TEST(Standing, RobotsOnTheirFeetDo) {
  EXPECT_EQ(fault(test::turned_biped({})), "");
  EXPECT_EQ(fault(test::armed_biped()), "");
  EXPECT_EQ(fault(test::classed_quadruped()), "");
  for (const char* name : {"puppy", "quadruped", "hexapod", "biped", "printed_quadruped"})
    EXPECT_EQ(fault(test::example_robot(name)), "");
}

TEST(Standing, FeetAboveTheCentreOfMassCarryNothing) {
  const std::string up = test::with(test::hopper_with("<geom size=\"0.02\" pos=\"0 0 -0.2\"/>"),
                                    "1 0 0 0 0 0", "1 0 0 0 3.1 0");
  EXPECT_NE(fault(up).find("feet are 0."), std::string::npos) << fault(up);
  EXPECT_NE(fault(up).find("above its centre of mass"), std::string::npos) << fault(up);
  EXPECT_NE(fault(up).find("a keyframe named home in which the feet carry the trunk"),
            std::string::npos);
}

TEST(Standing, ATrunkAsLowAsTheFeetLies) {
  const auto with_hull = [](double half) {
    return test::with(
        test::hopper_with("<geom size=\"0.02\" pos=\"0 0 -0.2\"/>"), "<body name=\"thigh\">",
        "<geom type=\"box\" size=\"0.1 0.1 " + std::to_string(half) + "\"/><body name=\"thigh\">");
  };
  EXPECT_EQ(fault(with_hull(0.3)), "");
  EXPECT_NE(fault(with_hull(0.42)).find("body 'trunk' reaches as low as its feet"),
            std::string::npos)
      << fault(with_hull(0.42));
}

}  // namespace
}  // namespace legwright
