// SPDX-License-Identifier: Apache-2.0
#include "tools/assemble/assembly_spots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/assemble/example_assemblies.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using test::assembly_of;
using test::module_of;

AssemblyItem put(Assembly& assembly, const std::string& spot, const std::string& module) {
  return put_module(assembly, spot, module_of(module), module_of("ball_foot_8"));
}

bool has_spot(const Assembly& assembly, const std::string& id) {
  const auto spots = assembly_spots(assembly);
  return std::any_of(spots.begin(), spots.end(), [&](const AssemblySpot& s) { return s.id == id; });
}

std::string refusal(Assembly assembly, const std::string& spot, const std::string& module) {
  try {
    put(assembly, spot, module);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(AssemblySpots, ANewLimbStandsOnTheTrunksFaceAndIsOfferedOnce) {
  Assembly dog = assembly_of("puppy");
  dog.limbs.clear();
  ASSERT_TRUE(has_spot(dog, "side/front"));
  EXPECT_EQ(to_string(put(dog, "side/front", "XL430-W250")), "limb/0/joint/0");
  const AssemblyLimb& leg = dog.limbs.at(0);
  EXPECT_EQ(leg.names.front(), "F");
  EXPECT_TRUE(leg.mirrored) << "its mirror image appears by itself";
  EXPECT_EQ(leg.joints[0].axis, Vector3d::UnitY()) << "out of the trunk";
  // The servo's body reaches 34 mm behind its horn: it touches the trunk, half as wide as 90 mm.
  EXPECT_NEAR(leg.hip.y(), 0.045 + 0.034, 2e-3);
  EXPECT_LT(leg.foot_offset.z(), -0.05);
  EXPECT_FALSE(has_spot(dog, "side/front")) << "a hip is there now";
  EXPECT_TRUE(has_spot(dog, "side/hind"));
  put(dog, "face/hind", "XL430-W250");
  EXPECT_FALSE(dog.limbs.at(1).mirrored) << "in the plane across which limbs mirror";
  EXPECT_EQ(dog.limbs.at(1).joints[0].axis, -Vector3d::UnitX());
}

TEST(AssemblySpots, ExamplesOfferNoHipThatIsTaken) {
  for (const char* name : {"puppy", "hexapod", "quadruped"}) {
    const Assembly robot = assembly_of(name);
    EXPECT_FALSE(has_spot(robot, "side/front")) << name;
    EXPECT_FALSE(has_spot(robot, "side/hind")) << name;
  }
  EXPECT_TRUE(has_spot(assembly_of("puppy"), "side/middle"));
  EXPECT_FALSE(has_spot(assembly_of("hexapod"), "side/middle"));
}

TEST(AssemblySpots, AnInsertedServoLeavesWhatIsBehindItWhereItIs) {
  Assembly dog = assembly_of("puppy");
  const Vector3d knee = dog.limbs[0].joints[1].offset, foot = dog.limbs[0].foot_offset;
  EXPECT_EQ(to_string(put(dog, "limb/0/before/1", "XM430-W350")), "limb/0/joint/1");
  const auto& joints = dog.limbs[0].joints;
  ASSERT_EQ(joints.size(), 3u);
  EXPECT_EQ(joints[1].servo.name, "XM430-W350");
  EXPECT_EQ(joints[1].offset + joints[2].offset, knee);
  EXPECT_EQ(dog.limbs[0].foot_offset, foot);
  put(dog, "limb/0/end", "XL430-W250");
  EXPECT_EQ(dog.limbs[0].joints[3].offset, foot) << "where the foot was";
  EXPECT_EQ(dog.limbs[0].foot_offset, foot) << "and as far on";
  EXPECT_NE(dog.limbs[0].joints[3].name, dog.limbs[0].joints[1].name);
}

TEST(AssemblySpots, ModulesTakeThePlaceOfOthersOfTheirKind) {
  Assembly dog = assembly_of("puppy");
  put(dog, "limb/0/joint/1", "XM430-W350");
  put(dog, "limb/0/foot", "ball_foot_20");
  put(dog, "trunk", "plate_200x100");
  put(dog, "part/0", "jetson_orin_nano");
  EXPECT_EQ(dog.limbs[0].joints[1].servo.name, "XM430-W350");
  EXPECT_EQ(dog.limbs[0].joints[0].servo.name, "XL430-W250");
  EXPECT_EQ(dog.limbs[0].foot.name, "ball_foot_20");
  EXPECT_EQ(dog.trunk.name, "plate_200x100");
  EXPECT_EQ(dog.parts[0].module.name, "jetson_orin_nano");
  EXPECT_TRUE(has_spot(dog, "ride/top")) << "an attachment of the plate";
  EXPECT_FALSE(has_spot(dog, "ride/middle"));
  put(dog, "ride/top", "lipo_3s_2200");
  EXPECT_GT(dog.parts[1].position.z(), 0.0025) << "its outline stands on the plate";
}

TEST(AssemblySpots, WhatDoesNotFitIsRefusedInWords) {
  const Assembly dog = assembly_of("puppy");
  EXPECT_NE(refusal(dog, "side/front", "XL430-W250").find("is taken"), std::string::npos);
  EXPECT_NE(refusal(dog, "limb/0/foot", "XL430-W250").find("takes no servo: it is in the place of"),
            std::string::npos);
  EXPECT_NE(refusal(dog, "limb/9/end", "XL430-W250").find("is no spot"), std::string::npos);
}

TEST(AssemblySpots, ALimbIsCopiedWithAllThatItHas) {
  Assembly dog = assembly_of("puppy");
  EXPECT_EQ(to_string(put_copy(dog, "side/middle", 0)), "limb/1");
  EXPECT_EQ(dog.limbs[1].names, std::vector<std::string>{"M"});
  EXPECT_EQ(dog.limbs[1].joints.size(), dog.limbs[0].joints.size());
  EXPECT_EQ(dog.limbs[1].foot_offset, dog.limbs[0].foot_offset);
  EXPECT_THROW(put_copy(dog, "limb/0/end", 0), InputError);
}

/// A linear actuator turns what hangs on a link: it begins no limb and is no hip.
TEST(AssemblySpots, ALinearActuatorGoesBelowTheFirstJoint) {
  Assembly dog = assembly_of("puppy");
  const auto takes_it = [&](const std::string& id) {
    for (const AssemblySpot& spot : assembly_spots(dog))
      if (spot.id == id) return takes(spot, ModuleKind::linear);
    ADD_FAILURE() << id;
    return false;
  };
  EXPECT_FALSE(takes_it("limb/0/joint/0"));
  EXPECT_TRUE(takes_it("limb/0/joint/1"));
  EXPECT_TRUE(takes_it("limb/0/before/1"));
  EXPECT_TRUE(takes_it("limb/0/end"));
  EXPECT_NE(refusal(dog, "limb/0/joint/0", "L16-50-35"), "");
  put(dog, "limb/0/joint/1", "L16-50-35");
  AssemblyJoint& knee = dog.limbs[0].joints[1];
  EXPECT_TRUE(knee.is_linear());
  knee.lever = {0.012, 0.0, 0.0};
  knee.mount = {0.012, 0.0, 0.14};
  put(dog, "limb/0/joint/1", "L12-20PT-3");  // of another length
  EXPECT_TRUE(knee.lever && !knee.mount);
  put(dog, "limb/0/joint/1", "XL430-W250");
  EXPECT_FALSE(knee.lever || knee.is_linear());
}

}  // namespace
}  // namespace legwright
