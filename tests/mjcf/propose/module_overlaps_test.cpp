// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/module_overlaps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/propose/home_touches.hpp"
#include "mjcf/read/robot_model.hpp"
#include "mjcf/text/compile.hpp"
#include "tests/mjcf/assembly/boxy_dog.hpp"

namespace legwright {
namespace {

using test::boxy_dog;

std::string xml_of(const Assembly& assembly) { return build_robot(assembly, "dog.xml").xml; }

std::vector<ModuleOverlap> overlaps_of(const Assembly& assembly) {
  return module_overlaps(*compile_mjcf(xml_of(assembly), "dog.xml"), "dog.xml");
}

/// Servos of front and hind hips, which begin 32 mm behind and before them, meet by 3 mm.
Assembly narrow_dog() {
  Assembly dog = boxy_dog();
  dog.limbs[0].hip.x() = 0.0305;
  dog.limbs[0].step = {-0.061, 0.0, 0.0};
  return dog;
}

TEST(ModuleOverlaps, AreOfOneBodyToo) {
  EXPECT_TRUE(overlaps_of(boxy_dog()).empty()) << "battery and hips are in the trunk";
  const std::vector<ModuleOverlap> found = overlaps_of(narrow_dog());
  ASSERT_GE(found.size(), 2u);
  EXPECT_EQ(found[0].first, "FL_hip_servo");
  EXPECT_EQ(found[0].second, "HL_hip_servo");
  EXPECT_NEAR(found[0].depth, 0.003, 1e-6);
  EXPECT_NEAR(std::abs(found[0].along.x()), 1.0, 1e-6);
  EXPECT_FALSE(found[0].is_deep);
  EXPECT_EQ(depth_words(found[0], "the other"), "3 mm inside the other along x");
}

TEST(ModuleOverlaps, AreDeepWhereAMiddleIsInTheOther) {
  Assembly dog = narrow_dog();
  dog.limbs[0].hip.x() = 0.01;
  dog.limbs[0].step.x() = -0.02;
  EXPECT_TRUE(overlaps_of(dog).at(0).is_deep);
}

/// Outlines are boxes around what is there.
TEST(ModuleOverlaps, AreNoneBelowTheTolerance) {
  Assembly dog = boxy_dog();
  dog.limbs[0].hip.x() = 0.0318;
  dog.limbs[0].step = {-0.0636, 0.0, 0.0};
  EXPECT_TRUE(overlaps_of(dog).empty());
}

/// A design may bring together what was drawn apart.
TEST(ModuleOverlaps, AreTouchesOfADesignWhereTheRobotHadNone) {
  const ModelPointer apart = compile_mjcf(xml_of(boxy_dog()), "dog.xml"),
                     together = compile_mjcf(xml_of(narrow_dog()), "dog.xml");
  const std::vector<HomeTouch> found = new_home_touches(*apart, *together, "dog.xml");
  ASSERT_EQ(found.size(), overlaps_of(narrow_dog()).size());
  EXPECT_EQ(found[0].first, "module 'FL_hip_servo'");
  EXPECT_EQ(found[0].second, "module 'HL_hip_servo'");
  EXPECT_NEAR(found[0].depth, 0.003, 1e-6);
  EXPECT_NE(describe(found).find("[print] in its assembly bounds links"), std::string::npos);
  EXPECT_TRUE(new_home_touches(*together, *together, "dog.xml").empty());
  EXPECT_TRUE(new_home_touches(*together, *apart, "dog.xml").empty());
}

TEST(ModuleOverlaps, AreToldOfARobotWithTheCureOfItsAssembly) {
  EXPECT_TRUE(overlapping_modules(parse_robot(xml_of(boxy_dog()), "dog.xml")).empty());
  const RobotModel robot = parse_robot(xml_of(narrow_dog()), "dog.xml");
  const std::vector<std::string> told = overlapping_modules(robot);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("'FL_hip_servo' is 3 mm inside 'HL_hip_servo' along x"), std::string::npos)
      << told[0];
  EXPECT_NE(told[0].find("in its assembly move them apart"), std::string::npos) << told[0];
  for (const std::string& link : overlapping_links(robot)) {
    EXPECT_EQ(link.find("<exclude"), std::string::npos) << link;
    EXPECT_EQ(link.find("_servo' is"), std::string::npos) << "told already: " << link;
  }
}

}  // namespace
}  // namespace legwright
