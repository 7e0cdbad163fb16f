// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/doubtful_assembly.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "tests/mjcf/robots/robots.hpp"
#include "tests/support/source_tree.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/modules/installed_modules.hpp"
#include "tests/tools/modules/told.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/modules/assembly_file.hpp"

namespace legwright {
namespace {

std::string assembly_doubts(const std::string& text,
                            const ModuleLibrary& library = test::installed_modules()) {
  const Assembly assembly = parse_assembly(text, "dog.toml", library);
  return fmt::format("{}",
                     fmt::join(doubts_on_assembly(assembly, text, "dog.toml", library), "\n"));
}

const std::string kPlainDog = R"(servo = "XL330-M288"
[trunk]
size = [0.14, 0.08, 0.03]
mass = 0.12
[link]
density = 1240
[[part]]
module = "lipo_3s_2200"
position = [0.0, 0.0, 0.03]
[[limb]]
names = ["F", "H"]
hip = [0.055, 0.03, 0.0]
step = [-0.11, 0.0, 0.0]
copies = 2
mirror = "y"
foot = "ball_foot_12"
foot_offset = [0.0, 0.0, -0.06]
[[limb.joint]]
name = "hip"
axis = [0, 1, 0]
range = [-0.7, 0.7]
[[limb.joint]]
name = "knee"
axis = [0, 1, 0]
offset = [0.0, 0.0, -0.06]
)";

TEST(DoubtfulAssemblies, NoneIsAmongTheExamples) {
  int read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::kExamples / "assemblies")) {
    const std::string text = read_file(entry.path());
    if (entry.path().extension() != ".toml" || !is_assembly(text, entry.path())) continue;
    EXPECT_EQ(assembly_doubts(text), "") << entry.path();
    ++read;
  }
  EXPECT_GE(read, 8);
  EXPECT_EQ(assembly_doubts(kPlainDog), "");
}

TEST(DoubtfulAssemblies, TellLineKeyAndTheUnitThatIsMeant) {
  test::expect_told(
      assembly_doubts(test::with(kPlainDog, "mass = 0.12", "mass = 120")),
      "dog.toml:4: trunk.mass: is 120 kg in 0.336 litres, 357143 kg/m3; expected at most "
      "10000; 120 g are 0.12 kg");
  test::expect_told(assembly_doubts(test::with(kPlainDog, "[0.14, 0.08, 0.03]", "[1.4, 0.8, 0.3]")),
                    "dog.toml:3: trunk.size: makes a shape of 0.12 kg in 336 litres");
  test::expect_told(
      assembly_doubts(test::with(kPlainDog, "1240", "1.24")),
      "dog.toml:6: link.density: is 1.24 kg/m3, less than foam has; 1.24 g/cm3 are 1240 "
      "kg/m3");
  test::expect_told(assembly_doubts(test::with(kPlainDog, "[0.0, 0.0, 0.03]", "[0, 0, 3.0]")),
                    "dog.toml:9: part.position: is [0, 0, 3] m, 18 times as long as the trunk from "
                    "corner to corner, 0.164 m; in cm it is [0, 0, 0.03] m");
  test::expect_told(assembly_doubts(test::with(kPlainDog, "foot_offset = [0.0, 0.0, -0.06]",
                                               "foot_offset = [0, 0, -4.5]")),
                    "dog.toml:17: limb.foot_offset: is [0, 0, -4.5] m");
  test::expect_told(assembly_doubts(test::with(kPlainDog, "foot_offset = [0.0, 0.0, -0.06]",
                                               "foot_offset = [0, 0, -4.5]")),
                    "in cm it is [0, 0, -0.045] m");
  test::expect_told(
      assembly_doubts(
          test::with(kPlainDog, "\noffset = [0.0, 0.0, -0.06]", "\noffset = [0, 0, -0.6]")),
      "dog.toml:25: limb.joint.offset: is [0, 0, -0.6] m, 3.7 times as long as the trunk "
      "from corner to corner, 0.164 m; with a digit less it is [0, 0, -0.06] m");
  test::expect_told(assembly_doubts(test::with(kPlainDog, "[-0.7, 0.7]", "[-40, 40]")),
                    "dog.toml:21: limb.joint.range: is [-40, 40] rad, more than a turn; [-40, 40] "
                    "degrees are [-0.6981, 0.6981] rad");
}

TEST(DoubtfulAssemblies, TellThoseOfTheirModulesAndFeetThatSlip) {
  const test::TemporaryFolder folder;
  const auto put = [&](const std::string& name, const std::string& part, const std::string& by) {
    std::string text = read_file(test::installed_modules().find(name).file);
    text.replace(text.find(part), part.size(), by);
    write_file(folder.path() / (name + ".toml"), text);
  };
  put("XL330-M288", "mass = 0.018", "mass = 18");
  put("ball_foot_12", "friction = 0.8", "friction = 0.6");
  const ModuleLibrary library({test::kSource / "modules", folder.path()});
  const std::string told = assembly_doubts(kPlainDog, library);
  EXPECT_NE(told.find("XL330-M288.toml:"), std::string::npos) << told;
  EXPECT_NE(told.find("18 g are 0.018 kg"), std::string::npos) << told;
  EXPECT_EQ(told.find("18 g are"), told.rfind("18 g are")) << "once";
  EXPECT_NE(told.find("dog.toml:16: limb.foot: is ball_foot_12, whose friction of 0.6 is below "
                      "that of the floor of tasks, 0.8, which holds whatever the foot has: give "
                      "tasks [limits] floor_friction = 0.6, and friction = 0.3 for the plan"),
            std::string::npos)
      << told;
}

}  // namespace
}  // namespace legwright
