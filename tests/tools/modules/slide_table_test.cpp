// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/slide_table.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/modules/linear_text.hpp"
#include "tests/tools/modules/servo_text.hpp"
#include "tools/modules/module_file.hpp"

namespace legwright {
namespace {

using test::kWholeLinear;

std::string slide_with(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), by);
}

void expect_slide_refused(const std::string& text, const std::string& part) {
  std::string told;
  try {
    (void)parse_module(text, "la1.toml");
  } catch (const InputError& error) {
    told = error.what();
  }
  EXPECT_NE(told.find(part), std::string::npos) << part << " in\n" << told;
}

TEST(SlideTable, IsReadWithEveryFigure) {
  const Module module = parse_module(kWholeLinear, "la1.toml").module;
  EXPECT_EQ(module.kind, ModuleKind::linear);
  ASSERT_TRUE(module.slide && !module.joint);
  const ModuleSlide& slide = *module.slide;
  EXPECT_EQ(slide.axis, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(slide.retracted, 0.12);
  EXPECT_EQ(slide.stroke, 0.05);
  EXPECT_NEAR(slide.middle(), 0.145, 1e-15);
  EXPECT_EQ(slide.most_force, 50.0);
  EXPECT_EQ(slide.line_force(), 100.0);
  EXPECT_EQ(slide.continuous_force, 20.0);
  EXPECT_EQ(slide.no_load_speed, 0.032);
  EXPECT_EQ(slide.backdrive_force, 31.0);
  EXPECT_EQ(slide.gear_ratio, 35.0);
  EXPECT_EQ(slide.reflected_mass, 90.0);
  EXPECT_EQ(slide.kp, 80000.0);
  EXPECT_EQ(slide.kd, 1000.0);
  EXPECT_TRUE(module.outline[0].on_rod && !module.outline[1].on_rod);
  EXPECT_TRUE(module.attachments[0].on_horn);
  EXPECT_EQ(rod_radius(module), 0.004);
  // By volume: the rod is 1.005 of 37.005 cm3.
  EXPECT_NEAR(without_rod(module).mass, 0.056 * 36.0 / (36.0 + 0.32 * std::numbers::pi), 1e-12);
}

TEST(SlideTable, WhatDoesNotFitIsTold) {
  expect_slide_refused(slide_with(kWholeLinear, "stall_force = 100.0", "stall_force = 40.0"),
                       "slide.stall_force: is 40, below max_force, 50");
  expect_slide_refused(
      slide_with(kWholeLinear, "continuous_force = 20.0", "continuous_force = 60.0"),
      "slide.continuous_force: is 60, above max_force, 50");
  expect_slide_refused(slide_with(kWholeLinear, "stroke = 0.05\n", ""), "slide.stroke: is missing");
  expect_slide_refused(slide_with(kWholeLinear, "gear_ratio = 35.0\n", ""),
                       "slide.gear_ratio: is named by a source");
  expect_slide_refused(
      slide_with(slide_with(kWholeLinear, "gear_ratio = 35.0\n", ""), "\"slide.gear_ratio\", ", ""),
      "slide.gear_ratio: is neither given nor said to be unknown");
  expect_slide_refused(slide_with(kWholeLinear, "\"slide.kp\",", ""), "slide.kp: has no source");
  expect_slide_refused(slide_with(kWholeLinear, "position = [0.0, 0.0, 0.05]\n",
                                  "position = [0.0, 0.0, 0.05]\non = \"rod\"\n"),
                       "puts all of its shape on the rod");
  expect_slide_refused(slide_with(kWholeLinear, "kind = \"linear\"", "kind = \"payload\""),
                       "slide: is for linear actuators, and this is a payload");
  expect_slide_refused(slide_with(test::kWholeServo, "on = \"horn\"", "on = \"rod\""),
                       "attachment.on: is \"rod\", and a servo has none");
  expect_slide_refused(slide_with(kWholeLinear, "on = \"rod\"\nposition = [0.0, 0.0, 0.12]",
                                  "on = \"horn\"\nposition = [0.0, 0.0, 0.12]"),
                       "attachment.on: is \"horn\", and a linear has none");
}

}  // namespace
}  // namespace legwright
