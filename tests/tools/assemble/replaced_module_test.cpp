// SPDX-License-Identifier: Apache-2.0
#include "tools/assemble/replaced_module.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/tools/assemble/example_assemblies.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using test::assembly_of;
using test::module_of;

void put(Assembly& assembly, const std::string& item, const Module& module) {
  replace_module(assembly, item_named(item, assembly), module);
}

Module box_of(const Assembly& assembly, const Vector3d& size) {
  Module box = assembly.trunk;
  box.outline.front().size = size;
  return box;
}

void expect_near(const Vector3d& found, const Vector3d& expected, const char* what) {
  EXPECT_LT((found - expected).norm(), 1e-12) << what << ": " << found.transpose();
}

TEST(ReplacedModule, HipsAndRidersGoAlongWithTheTrunk) {
  Assembly dog = assembly_of("puppy");  // of 200 x 90 x 40 mm, hips 25 mm beside it
  dog.parts.push_back({module_of("jetson_orin_nano"), Vector3d::Zero()});
  const ModuleExtent board = extent_of(dog.parts[1].module);
  dog.parts[1].position = Vector3d(0.05, 0.0, 0.02 + board.half.z()) - board.middle;
  const Vector3d battery = dog.parts[0].position;
  put(dog, "trunk", box_of(dog, {0.3, 0.12, 0.06}));
  expect_near(dog.limbs[0].hip, {0.135, 0.06 + 0.025, 0.0}, "front hip");
  expect_near(dog.limbs[0].hip + dog.limbs[0].step, {-0.135, 0.06 + 0.025, 0.0}, "hind hip");
  expect_near(dog.parts[1].position + board.middle, {0.075, 0.0, 0.03 + board.half.z()}, "on top");
  expect_near(dog.parts[0].position, battery, "in the middle");
  put(dog, "trunk", box_of(dog, {0.2, 0.09, 0.04}));
  expect_near(dog.limbs[0].hip, {0.09, 0.07, 0.0}, "and back");
}

TEST(ReplacedModule, OfTheSameSizeMovesNothing) {
  Assembly dog = assembly_of("quadruped");
  dog.limbs[0].hip = {0.1 / 3.0, 0.07, -0.011};
  const Vector3d hip = dog.limbs[0].hip, step = dog.limbs[0].step;
  Module heavier = dog.trunk;
  heavier.mass *= 2.0;
  put(dog, "trunk", heavier);
  EXPECT_EQ(dog.trunk.mass, heavier.mass);
  EXPECT_EQ(dog.limbs[0].hip, hip);
  EXPECT_EQ(dog.limbs[0].step, step);
  put(dog, "trunk", box_of(dog, {-0.2, 0.1, 0.05}));  // which is refused later, with its own words
  EXPECT_EQ(dog.limbs[0].hip, hip);
}

TEST(ReplacedModule, AServoOfAHipKeepsThePlaceOfItsBack) {
  Assembly dog = assembly_of("puppy");
  const auto back = [&] {
    const AssemblyJoint& first = dog.limbs[0].joints[0];
    return dog.limbs[0].hip.y() - depth_behind_horn(first.servo);
  };
  const double before = back(), knee = dog.limbs[0].joints[1].offset.z();
  const double hip = dog.limbs[0].hip.y();
  put(dog, "limb/0/joint/0", module_of("XM540-W270"));
  EXPECT_NEAR(back(), before, 1e-12);
  EXPECT_GT(dog.limbs[0].hip.y(), hip) << "which is deeper";
  const Vector3d there = dog.limbs[0].hip;
  put(dog, "limb/0/joint/1", module_of("XM540-W270"));
  EXPECT_EQ(dog.limbs[0].hip, there) << "of another joint";
  EXPECT_EQ(dog.limbs[0].joints[1].offset.z(), knee);
}

TEST(ReplacedModule, ARiderStandsOnTheSameSide) {
  Assembly dog = assembly_of("puppy");
  const Module &board = module_of("jetson_orin_nano"), &battery = module_of("lipo_3s_2200");
  const double face = extent_of(dog.trunk).half.z();
  const auto above = [&] {
    const ModuleExtent extent = extent_of(dog.parts[0].module);
    return dog.parts[0].position.z() + extent.middle.z() - extent.half.z() - face;
  };
  const ModuleExtent flat = extent_of(battery);
  dog.parts[0] = {battery, Vector3d(0.0, 0.0, face + flat.half.z()) - flat.middle};
  put(dog, "part/0", board);
  EXPECT_EQ(dog.parts[0].module.name, board.name);
  EXPECT_NEAR(above(), 0.0, 1e-12) << "on the trunk";
  EXPECT_GT(std::abs(extent_of(board).half.z() - flat.half.z()), 1e-4) << "they differ in height";
}

TEST(ReplacedModule, AFootIsPutWhereTheOldOneWas) {
  Assembly dog = assembly_of("puppy");
  const Vector3d offset = dog.limbs[0].foot_offset;
  put(dog, "limb/0/foot", module_of("ball_foot_20"));
  EXPECT_EQ(dog.limbs[0].foot.name, "ball_foot_20");
  EXPECT_EQ(dog.limbs[0].foot_offset, offset);
}

}  // namespace
}  // namespace legwright
