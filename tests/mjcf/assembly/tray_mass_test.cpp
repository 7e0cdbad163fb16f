// SPDX-License-Identifier: Apache-2.0
// What a trunk weighs as it is printed: of a bare box by its walls, more with what stands on it,
// and a robot's file has no trunk that is lighter.
#include "mjcf/assembly/tray_mass.hpp"

#include <gtest/gtest.h>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "tests/mjcf/assembly/boxy_dog.hpp"

namespace legwright::test {
namespace {

Assembly dog_on_tray(double mass) {
  Assembly out = hulled_dog();
  out.print = PrintLimits{};
  out.trunk.mass = mass;
  return out;
}

double trunk_mass(const BuiltRobot& built) {
  const ModelPointer model = compile_mjcf(built.xml, "dog.xml");
  return model->body_mass[mj_name2id(model.get(), mjOBJ_BODY, "trunk")];
}

TEST(TrayMass, OfABareBoxIsThatOfFloorAndWalls) {
  Assembly bare = dog_on_tray(0.1);
  bare.parts.clear();
  bare.limbs.clear();
  const double wall = 2.4e-3, floor = 0.2 * 0.09 * wall,
               walls = (0.2 * 0.09 - (0.2 - 2 * wall) * (0.09 - 2 * wall)) * (0.04 - wall);
  EXPECT_NEAR(tray_mass(bare), 1240.0 * (floor + walls), 0.06 * 1240.0 * (floor + walls));
  EXPECT_GE(tray_mass(bare), 1240.0 * (floor + walls));
  bare.trunk.outline[0].size.z() = 0.005;
  EXPECT_NEAR(tray_mass(bare), 1240.0 * 0.2 * 0.09 * 0.005, 0.01) << "a plate";
}

TEST(TrayMass, GrowsWithTheBoxAndWithWhatStandsOnIt) {
  const Assembly dog = dog_on_tray(0.1);
  Assembly bare = dog;
  bare.parts.clear();
  bare.limbs.clear();
  EXPECT_GT(tray_mass(dog), tray_mass(bare) + 0.01);
  EXPECT_GT(tray_mass(dog, {1.2, 1.0, 1.0}), tray_mass(dog) + 0.005);
}

TEST(TrayMass, IsTheLeastOfARobotThatIsToBePrinted) {
  const BuiltRobot light = build_robot(dog_on_tray(0.05), "dog.xml"),
                   heavy = build_robot(dog_on_tray(0.5), "dog.xml");
  EXPECT_GE(trunk_mass(light), tray_mass(dog_on_tray(0.05)));
  ASSERT_FALSE(light.notes.empty());
  EXPECT_NE(light.notes.back().find("not the 0.05 kg"), std::string::npos) << light.notes.back();
  EXPECT_EQ(trunk_mass(heavy), 0.5);
  Assembly plain = dog_on_tray(0.05);
  plain.print.reset();
  EXPECT_EQ(trunk_mass(build_robot(plain, "dog.xml")), 0.05) << "which nobody prints";
}

}  // namespace
}  // namespace legwright::test
