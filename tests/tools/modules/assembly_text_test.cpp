// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/assembly_text.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "mjcf/assembly/assembly_xml.hpp"
#include "mjcf/text/input_error.hpp"
#include "tests/support/source_tree.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/modules/assembly_file.hpp"

namespace legwright {
namespace {

const ModuleLibrary& library() {
  static const ModuleLibrary read({test::kSource / "modules"});
  return read;
}

Assembly read_back(const Assembly& assembly) {
  return parse_assembly(assembly_text(assembly), "again.toml", library());
}

TEST(AssemblyText, EveryExampleIsTheSameRobotAfterwards) {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(test::kExamples / "assemblies")) {
    if (file.path().extension() != ".toml") continue;
    const Assembly assembly = parse_assembly(read_file(file.path()), file.path(), library());
    const Assembly again = read_back(assembly);
    EXPECT_EQ(assembly_xml(again, 0.1), assembly_xml(assembly, 0.1)) << file.path();
    EXPECT_EQ(assembly_text(again), assembly_text(assembly)) << "the same bytes from then on";
    ++count;
  }
  EXPECT_GE(count, 6);
}

TEST(AssemblyText, EveryKeyIsWritten) {
  Assembly dog = parse_assembly(read_file(test::kExamples / "assemblies" / "quadruped.toml"),
                                "quadruped.toml", library());
  dog.torque = TorqueLimit::continuous;
  dog.torque_share = 0.5;
  dog.armature = 0.004;
  dog.only_feet_touch = true;
  dog.link_radius = 0.007;
  dog.link_wall = 0.004;
  dog.link_clearance = 0.002;
  dog.link_density = 1000.0;
  dog.print = PrintLimits{{0.18, 0.2}, 0.4, 0.006};
  dog.parts[0].position = {0.01, 0.0, 0.02};
  AssemblyJoint& knee = dog.limbs[0].joints[2];
  knee.servo = library().find("XM430-W350").module;
  knee.range = {-1.0, 0.5};
  knee.roll = 0.25;
  const Assembly again = read_back(dog);
  EXPECT_EQ(again.torque, TorqueLimit::continuous);
  EXPECT_EQ(again.torque_share, 0.5);
  EXPECT_EQ(again.armature, 0.004);
  EXPECT_TRUE(again.only_feet_touch);
  ASSERT_TRUE(again.print);
  EXPECT_EQ(again.print->bed, dog.print->bed);
  EXPECT_EQ(again.print->turn, 0.4);
  EXPECT_EQ(again.print->margin, 0.006);
  dog.print = PrintLimits{};
  EXPECT_EQ(read_back(dog).print.value().bed, PrintLimits{}.bed) << "[print] with nothing in it";
  EXPECT_EQ(again.link_radius, 0.007);
  EXPECT_EQ(again.link_wall, 0.004);
  EXPECT_EQ(again.link_clearance, 0.002);
  EXPECT_EQ(again.link_density, 1000.0);
  EXPECT_EQ(again.parts[0].position, dog.parts[0].position);
  const AssemblyJoint& read = again.limbs[0].joints[2];
  EXPECT_EQ(read.servo.name, "XM430-W350");
  EXPECT_EQ(again.limbs[0].joints[0].servo.name, "XL430-W250") << "that of the file";
  EXPECT_EQ(read.range, knee.range);
  EXPECT_EQ(read.roll, 0.25);
  EXPECT_EQ(read.link, "shank");
}

TEST(AssemblyText, ADraftHasNoLimbYet) {
  const std::string text = "name = \"new\"\n\n[trunk]\nsize = [0.2, 0.1, 0.04]\nmass = 0.3\n";
  const Assembly trunk = parse_assembly(text, "new.toml", library(), AssemblyState::draft);
  EXPECT_EQ(assembly_text(trunk), text);
  EXPECT_THROW((void)parse_assembly(text, "new.toml", library()), InputError);
}

TEST(IsAssembly, ByWhatItHoldsAndNotByItsName) {
  EXPECT_TRUE(is_assembly("[trunk]\nsize = [1, 1, 1]\n", "x.toml"));
  EXPECT_TRUE(is_assembly("[[limb]]\nname = \"F\"\n", "x.toml")) << "whose trunk is missing";
  EXPECT_FALSE(is_assembly("robot = \"robot.xml\"\n", "x.toml"));
  EXPECT_FALSE(is_assembly("", "x.toml"));
  EXPECT_THROW((void)is_assembly("= 3", "x.toml"), InputError);
}

}  // namespace
}  // namespace legwright
