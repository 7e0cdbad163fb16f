// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/module_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/tools/modules/servo_text.hpp"

namespace legwright {
namespace {

using test::kWholeServo;

/// What the reader says of a text; empty where it takes it.
std::string refusal(const std::string& text) {
  try {
    (void)parse_module(text, "hs1.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The whole servo with one part of its text replaced, or taken out.
std::string servo_with(const std::string& part, const std::string& by) {
  return test::with(kWholeServo, part, by);
}

void expect_refusal(const std::string& text, const std::vector<std::string>& parts) {
  const std::string told = refusal(text);
  EXPECT_NE(told, "");
  for (const std::string& part : parts)
    EXPECT_NE(told.find(part), std::string::npos) << part << " in\n" << told;
}

TEST(ModuleFile, TakesAPriceWithoutASource) {
  EXPECT_FALSE(parse_module(kWholeServo, "hs1.toml").module.price.has_value());
  const std::string priced = servo_with("voltage = 6.0", "voltage = 6.0\nprice = 23.9");
  EXPECT_EQ(parse_module(priced, "hs1.toml").module.price, 23.9);
  expect_refusal(servo_with("voltage = 6.0", "voltage = 6.0\nprice = -1.0"), {"price", "-1"});
}

TEST(ModuleFile, TakesSidesOfCablesThatAreAttachmentsAndHaveASource) {
  const std::string back =
      "[[attachment]]\nname = \"back\"\nposition = [0, 0, -0.018]\nnormal = [0, 0, -1]\n\n"
      "[[attachment]]\nname = \"horn\"";
  std::string text = servo_with("[[attachment]]\nname = \"horn\"", back);
  text.insert(text.find("mass = 0.055"), "cable = [\"back\"]\n");
  expect_refusal(text, {"cable", "has no source"});
  text.replace(text.find("\"mass\", \"voltage\""), 6, "\"mass\", \"cable\"");
  EXPECT_EQ(parse_module(text, "hs1.toml").module.cable, std::vector<std::string>{"back"});
  text.replace(text.find("[\"back\"]"), 8, "[\"horn\"]");
  expect_refusal(text, {"names \"horn\"", "there are back"});
}

TEST(ModuleFile, ReadsAWholeServo) {
  const ModuleFile file = parse_module(kWholeServo, "hs1.toml");
  const Module& module = file.module;
  EXPECT_EQ(module.name, "HS-1");
  EXPECT_EQ(module.kind, ModuleKind::servo);
  EXPECT_EQ(module.mass, 0.055);
  EXPECT_EQ(module.voltage, 6.0);
  ASSERT_EQ(module.outline.size(), 1u);
  EXPECT_EQ(module.outline[0].size, Eigen::Vector3d(0.02, 0.04, 0.036));
  ASSERT_TRUE(module.joint.has_value());
  EXPECT_EQ(module.joint->axis, Eigen::Vector3d::UnitZ()) << "of length 1";
  EXPECT_EQ(module.joint->stall_torque, 1.1);
  EXPECT_EQ(module.joint->continuous_torque, 0.2);
  EXPECT_EQ(module.joint->reflected_inertia, 0.002);
  EXPECT_EQ((*module.joint->range)[1], 1.5);
  ASSERT_EQ(module.attachments.size(), 1u);
  EXPECT_TRUE(module.attachments[0].on_horn);
  EXPECT_EQ(module.attachments[0].screws, "M2");
  ASSERT_EQ(module.attachments[0].holes.size(), 4u);
  EXPECT_TRUE(module.attachments[0].holes[1].isApprox(
      Eigen::Vector3d(-0.008 * std::sin(0.1), 0.01 + 0.008 * std::cos(0.1), 0.018), 1e-12));
  EXPECT_EQ(file.source_count("mass"), 1u);
  EXPECT_EQ(file.source_count("joint.position"), 0u);
  EXPECT_EQ(file.assumptions.at(0).why, "half the width from the end");
}

TEST(ModuleFile, AttachmentsHaveNamesThatARobotCanHold) {
  for (const char* name : {"horn side", "b&k", "a;b"})
    expect_refusal(servo_with("name = \"horn\"", "name = \"" + std::string(name) + "\""),
                   {"attachment.name", "expected letters, digits, '_', '-' and '.'"});
}

TEST(ModuleFile, ScrewsHaveASizeAndPlacesInThePlaneOfTheirAttachment) {
  expect_refusal(servo_with("screws = \"M2\"", "screws = \"4 x M2\""),
                 {"attachment.screws", "is \"4 x M2\"; expected one of M1.6, M2"});
  expect_refusal(servo_with("count = 4\n", ""), {"attachment.screws", "circle = 0.016, count = 4"});
  expect_refusal(servo_with("screws = \"M2\"\n", ""), {"attachment.screws", "and that with it"});
  expect_refusal(servo_with("turn = 0.1", "holes = [0.0, 0.0]"),
                 {"attachment.holes", "has 2 numbers"});
  expect_refusal(servo_with("turn = 0.1", "holes = [0.0, 0.0, 0.017]"),
                 {"attachment.holes", "hole 1 is -1 mm off the plane"});
  const ModuleFile file =
      parse_module(servo_with("turn = 0.1", "holes = [0.0, 0.0, 0.018]"), "hs1.toml");
  EXPECT_EQ(file.module.attachments.at(0).holes.at(4), Eigen::Vector3d(0.0, 0.0, 0.018));
}

TEST(ModuleFile, AFigureHasASourceOrAnAssumption) {
  expect_refusal(servo_with("\"mass\", ", ""), {"hs1.toml:5: mass: has no source"});
  expect_refusal(servo_with("figures = [\"joint.position\"]", "figures = [\"mass\"]"),
                 {"joint.position", "has no source"});
  expect_refusal(servo_with("friction = 0.02\n", ""),
                 {"joint.friction", "is named by a source or an assumption and is not given"});
  for (const char* mass : {"\"55 g\"", "550", "nan"}) {
    const std::string told = refusal(servo_with("0.055", mass));
    EXPECT_NE(told.find("mass: is "), std::string::npos) << told;
    EXPECT_EQ(told.find("is not given"), std::string::npos) << "it is, and refused\n" << told;
  }
}

TEST(ModuleFile, TellsTheUnitThatWasMeant) {
  expect_refusal(servo_with("0.055", "550"), {"expected 0 < mass <= 100 kg; 550 g are 0.55 kg"});
  expect_refusal(servo_with("[0.02, 0.04, 0.036]", "[20, 0.04, 0.036]"),
                 {"outline.size: is 20", "; 20 cm are 0.2 m, 20 mm are 0.02 m"});
  EXPECT_EQ(refusal(servo_with("0.055", "-550")).find(" g are"), std::string::npos);
}

TEST(ModuleFile, TheRangeOfAServoHasZeroWithin) {
  for (const char* range : {"[0.5, 3.5]", "[-3.5, -0.5]"})
    expect_refusal(servo_with("[-1.5, 1.5]", range),
                   {"hs1.toml:23: joint.range: is " + std::string(range) + ", without zero",
                    "as [-1.5, 1.5]"});
  EXPECT_EQ(refusal(servo_with("[-1.5, 1.5]", "[0, 3]")), "");
}

TEST(ModuleFile, AttachmentsHaveNamesOfTheirOwn) {
  const std::string twin =
      "\n[[attachment]]\nname = \"horn\"\nposition = [0, 0, -0.018]\nnormal = [0, 0, -1]\n";
  expect_refusal(kWholeServo + twin,
                 {"hs1.toml:50: attachment.name: is \"horn\" a second time; give each"});
}

TEST(ModuleFile, WhatAServoMayHaveIsGivenOrSaidToBeUnknown) {
  std::string text = servo_with("friction = 0.02\n", "");
  const std::string cited = "\"joint.friction\",";
  text.erase(text.find(cited), cited.size());
  expect_refusal(text, {"joint.friction", "is neither given nor said to be unknown"});
  EXPECT_EQ(refusal("unknown = [\"joint.friction\"]\n" + text), "");
  expect_refusal("unknown = [\"joint.friction\"]\n" + kWholeServo,
                 {"unknown", "names \"joint.friction\", which is given"});
  expect_refusal("unknown = [\"joint.fricton\"]\n" + text, {"did you mean \"joint.friction\"?"});
}

TEST(ModuleFile, TeachesWhatIsWrongAllAtOnce) {
  std::string text = servo_with("mass = 0.055", "mass = -1");
  const auto replace = [&](const std::string& part, const std::string& by) {
    text.replace(text.find(part), part.size(), by);
  };
  replace("stall_torque = 1.1", "stal_torque = 1.1");
  replace("[0.02, 0.04, 0.036]", "[0.02, 0.04]");
  replace("range = [-1.5, 1.5]", "range = [1.5, -1.5]");
  expect_refusal(text, {"mass: is -1; expected 0 < mass <= 100 kg",
                        "joint.stal_torque: unknown key; did you mean 'joint.stall_torque'?",
                        "outline.size: has 2 numbers; a box has 3: widths along x, y and z",
                        "joint.range: is [1.5, -1.5]; expected the lesser angle first",
                        "docs/module_file.md"});
}

TEST(ModuleFile, RefusesWhatFitsNoModuleOfItsKind) {
  expect_refusal(servo_with("kind = \"servo\"", "kind = \"servos\""),
                 {"expected one of servo, linear, foot, trunk"});
  expect_refusal(servo_with("kind = \"servo\"", "kind = \"battery\""),
                 {"joint", "is for servos, and this is a battery"});
  const std::string foreign = refusal("name = \"a\"\nkind = \"servos\"\n[joint]\nkp = 1.0\n");
  for (const char* part : {"joint: ", "joint.stall_torque", "joint.gear_ratio"})
    EXPECT_EQ(foreign.find(part), std::string::npos) << foreign;
  const std::string battery =
      refusal(servo_with("stall_torque = 1.1\n", "")
                  .replace(kWholeServo.find("\"servo\""), 7, "\"battery\""));
  EXPECT_EQ(battery.find("joint.stall_torque: is missing"), std::string::npos) << battery;
  expect_refusal(servo_with("[joint]", "[foot]\nfriction = 0.9\n[joint]"),
                 {"foot", "is for feet, and this is a servo"});
  expect_refusal(servo_with("continuous_torque = 0.2", "continuous_torque = 2.0"),
                 {"joint.continuous_torque", "above the stall torque of 1.1"});
  expect_refusal(servo_with("normal = [0, 0, 1]", "normal = [0, 0, 0]"), {"has no length"});
  expect_refusal(servo_with("\"HS-1\"", "\"HS 1\""), {"expected letters, digits"});
  expect_refusal(servo_with("shape = \"box\"", "shape = \"cube\""),
                 {"expected one of box, cylinder, sphere"});
  expect_refusal("name = \n", {"hs1.toml:1: "});
  expect_refusal("name = \"a\"\n", {"kind: is missing", "mass: is missing", "outline: is missing"});
}

}  // namespace
}  // namespace legwright
