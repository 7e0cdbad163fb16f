// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/doubtful_module.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "tests/mjcf/robots/robots.hpp"
#include "tests/tools/modules/installed_modules.hpp"
#include "tests/tools/modules/linear_text.hpp"
#include "tests/tools/modules/servo_text.hpp"
#include "tests/tools/modules/told.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/modules/module_library.hpp"
#include "tools/task/toml_text.hpp"

namespace legwright {
namespace {

/// What is doubtful about a module, a line each.
std::string module_doubts(const std::string& text) {
  return fmt::format("{}", fmt::join(parse_module(text, "hs1.toml").doubts, "\n"));
}

/// What is doubtful about a module of the library with other figures.
std::string changed_doubts(const ModuleFile& file, const Module& changed) {
  const toml::table toml = parse_toml(read_file(file.file), file.file);
  return fmt::format("{}", fmt::join(doubts_on_module(changed, toml, file.file), "\n"));
}

TEST(DoubtfulModules, NoneIsInTheLibrary) {
  for (const ModuleFile& file : test::installed_modules().modules())
    EXPECT_TRUE(file.doubts.empty()) << file.doubts.front();
  EXPECT_EQ(module_doubts(test::kWholeServo), "");
}

/// Each servo of the library with its figures in units of data sheets.
TEST(DoubtfulModules, TellTheUnitsOfDataSheets) {
  constexpr double kToKgCm = 10.1972, kToNcm = 100.0, kToRpm = 9.5493;
  int checked = 0;
  for (const ModuleFile& file : test::installed_modules().modules()) {
    if (file.module.kind != ModuleKind::servo) continue;
    const auto expect = [&](const Module& changed, const std::string& part) {
      const std::string told = changed_doubts(file, changed);
      EXPECT_NE(told.find(part), std::string::npos) << part << " in\n" << told;
      ++checked;
    };
    const double torque = file.module.joint->stall_torque;
    Module changed = file.module;
    changed.joint->stall_torque = kToKgCm * torque;
    expect(changed, fmt::format("kg cm are {:.4g} N m", torque));
    changed.joint->stall_torque = kToNcm * torque;
    expect(changed, fmt::format("N cm are {:.4g} N m", torque));
    changed = file.module;
    changed.mass *= 1e3;
    expect(changed, fmt::format("g are {:.4g} kg", file.module.mass));
    changed = file.module;
    for (OutlineShape& shape : changed.outline) {
      shape.size *= 100.0;
      shape.position *= 100.0;
    }
    expect(changed, "outline.size: makes a shape of");
    changed = file.module;
    changed.joint->position *= 10.0;
    if (changed.joint->position.norm() > 0.0) expect(changed, "with a digit less it is");
    if (!file.module.joint->no_load_speed) continue;
    changed = file.module;
    changed.joint->no_load_speed = kToRpm * *file.module.joint->no_load_speed;
    expect(changed, fmt::format("rev/min are {:.4g} rad/s", *file.module.joint->no_load_speed));
  }
  EXPECT_GE(checked, 100);
}

TEST(DoubtfulModules, AreToldWithLineAndKey) {
  const std::string& servo = test::kWholeServo;
  test::expect_told(
      module_doubts(test::with(servo, "stall_torque = 1.1", "stall_torque = 110")),
      "hs1.toml:16: joint.stall_torque: is 110 N m of a servo of 0.055 kg, 2000 N m/kg, "
      "where servos have up to 65; 110 N cm are 1.1 N m");
  test::expect_told(
      module_doubts(test::with(servo, "no_load_speed = 6.0", "no_load_speed = 57")),
      "hs1.toml:18: joint.no_load_speed: is 57 rad/s, and 14250 of the motor before its "
      "gears, where motors have up to 3000; 57 rev/min are 5.969 rad/s");
  test::expect_told(module_doubts(test::with(servo, "mass = 0.055", "mass = 55")),
                    "hs1.toml:5: mass: is 55 kg in 0.0288 litres, 1909722 kg/m3; expected at most "
                    "10000; 55 g are 0.055 kg");
  test::expect_told(
      module_doubts(test::with(servo, "size = [0.02, 0.04, 0.036]", "size = [2, 4, 3.6]")),
      "hs1.toml:10: outline.size: makes a shape of 0.055 kg in 28800 litres");
  test::expect_told(
      module_doubts(test::with(servo, "range = [-1.5, 1.5]", "range = [-90, 90]")),
      "hs1.toml:23: joint.range: is [-90, 90] rad, more than a turn; [-90, 90] degrees are "
      "[-1.571, 1.571] rad");
  test::expect_told(module_doubts(test::with(servo, "turn = 0.1", "turn = 45")),
                    "attachment.turn: is 45 rad, more than a turn; 45 degrees are 0.7854 rad");
  test::expect_told(
      module_doubts(test::with(servo, "[joint]\nposition = [0.0, 0.01, 0.018]",
                               "[joint]\nposition = [0.0, 0.1, 0.18]")),
      "hs1.toml:14: joint.position: is 0.1807 m away from the outline of [0.02, 0.04, "
      "0.036] m; with a digit less it is [0, 0.01, 0.018] m");
}

TEST(DoubtfulModules, TellMillimetresASecondAndCentimetresOfRods) {
  const std::string& rod = test::kWholeLinear;
  EXPECT_EQ(module_doubts(rod), "");
  test::expect_told(module_doubts(test::with(rod, "stroke = 0.05", "stroke = 5.0")),
                    "slide.stroke: is 5 m of an actuator that is 0.12 m long with its rod in; "
                    "5 cm are 0.05 m");
  test::expect_told(module_doubts(test::with(rod, "no_load_speed = 0.032", "no_load_speed = 32")),
                    "slide.no_load_speed: is 32 m/s of the rod, where linear actuators have up "
                    "to 0.1; 32 mm/s are 0.032 m/s");
}

}  // namespace
}  // namespace legwright
