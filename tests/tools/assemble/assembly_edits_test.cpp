// SPDX-License-Identifier: Apache-2.0
#include "tools/assemble/assembly_edits.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/assemble/example_assemblies.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using test::assembly_of;

void set(Assembly& assembly, const std::string& item, const std::string& key, const Json& value) {
  set_value(assembly, item_named(item, assembly), key, value);
}

std::string refusal(const std::string& item, const std::string& key, const Json& value) {
  Assembly assembly = assembly_of("quadruped");
  try {
    set(assembly, item, key, value);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(AssemblyItem, NamesAreReadBack) {
  const Assembly dog = assembly_of("quadruped");
  for (const char* name :
       {"trunk", "part/0", "limb/0", "limb/0/foot", "limb/0/joint/0", "limb/0/joint/2"})
    EXPECT_EQ(to_string(item_named(name, dog)), name);
  for (const char* name : {"", "part/1", "limb/1", "limb/0/joint/3", "limb/0/joint", "limb/00"})
    EXPECT_THROW(item_named(name, dog), InputError) << name;
  EXPECT_EQ(words_of(item_named("limb/0/joint/2", dog), dog), "the servo of knee in F, H");
}

TEST(AssemblyEdits, WhatIsBehindARemovedJointStaysWhereItIs) {
  const Assembly whole = assembly_of("quadruped");
  const AssemblyLimb& leg = whole.limbs[0];
  const Vector3d foot = leg.hip + leg.joints[1].offset + leg.joints[2].offset + leg.foot_offset;
  for (const char* item : {"limb/0/joint/0", "limb/0/joint/1", "limb/0/joint/2"}) {
    Assembly dog = whole;
    remove_item(dog, item_named(item, dog));
    ASSERT_EQ(dog.limbs[0].joints.size(), 2u) << item;
    EXPECT_EQ(dog.limbs[0].joints[0].offset, Vector3d::Zero()) << item;
    const Vector3d now =
        dog.limbs[0].hip + dog.limbs[0].joints[1].offset + dog.limbs[0].foot_offset;
    EXPECT_LT((now - foot).norm(), 1e-12) << item;
  }
}

TEST(AssemblyEdits, ALimbGoesWithItsLastJointAndATrunkStays) {
  Assembly dog = assembly_of("quadruped");
  for (int k = 0; k < 3; ++k) remove_item(dog, item_named("limb/0/joint/0", dog));
  EXPECT_TRUE(dog.limbs.empty());
  remove_item(dog, item_named("part/0", dog));
  EXPECT_TRUE(dog.parts.empty());
  EXPECT_THROW(remove_item(dog, item_named("trunk", dog)), InputError);
}

TEST(AssemblyEdits, KeysAreThoseOfTheFile) {
  Assembly dog = assembly_of("quadruped");
  set(dog, "limb/0/joint/1", "axis", {0.0, 0.8, 0.6});
  set(dog, "limb/0/joint/1", "range", {-1.0, 0.5});
  set(dog, "limb/0/joint/1", "name", "pitch");
  set(dog, "trunk", "size", {0.3, 0.1, 0.05});  // hips go along with it
  set(dog, "limb/0", "hip", {0.1, 0.05, 0.01});
  set(dog, "limb/0/foot", "offset", {0.0, 0.0, -0.12});
  EXPECT_EQ(dog.limbs[0].joints[1].axis, Vector3d(0.0, 0.8, 0.6));
  EXPECT_EQ((*dog.limbs[0].joints[1].range)[1], 0.5);
  EXPECT_EQ(dog.limbs[0].joints[1].name, "pitch");
  EXPECT_EQ(dog.limbs[0].joints[1].link, "thigh") << "which has a name of its own";
  EXPECT_EQ(dog.limbs[0].hip.x(), 0.1);
  EXPECT_EQ(dog.limbs[0].foot_offset.z(), -0.12);
  EXPECT_EQ(dog.trunk.outline[0].size.x(), 0.3);
  set(dog, "limb/0/joint/1", "range", nullptr);
  EXPECT_FALSE(dog.limbs[0].joints[1].range);
}

TEST(AssemblyEdits, CopiesStandBehindEachOther) {
  Assembly dog = assembly_of("quadruped");
  set(dog, "limb/0", "copies", 1);
  EXPECT_EQ(dog.limbs[0].names, std::vector<std::string>{"F"});
  dog.limbs[0].step.setZero();
  set(dog, "limb/0", "copies", 3);
  EXPECT_EQ(dog.limbs[0].names, (std::vector<std::string>{"F", "F2", "F3"}));
  EXPECT_NEAR(dog.limbs[0].step.x(), -dog.limbs[0].hip.x(), 1e-12) << "one in the middle";
  Assembly other = assembly_of("quadruped");
  set(other, "limb/0", "copies", 1);
  other.limbs[0].step.setZero();
  other.limbs[0].hip.x() = 0.0;
  set(other, "limb/0", "copies", 2);
  EXPECT_LT(other.limbs[0].step.x(), -0.05) << "behind one in the trunk's middle";
}

TEST(AssemblyEdits, WhatIsNoKeyOrNoValueIsRefusedInWords) {
  EXPECT_NE(refusal("limb/0", "axis", {0, 1, 0}).find("'axis' is no key of limb/0; expected names"),
            std::string::npos);
  EXPECT_NE(refusal("limb/0/joint/0", "axis", "up").find("expected three numbers"),
            std::string::npos);
  EXPECT_NE(refusal("limb/0", "copies", 17).find("expected 1 to 16"), std::string::npos);
  EXPECT_NE(refusal("limb/0", "copies", 1.5).find("expected a whole number"), std::string::npos);
  EXPECT_NE(refusal("limb/0", "names", Json::array({"F"})).find("'names' has 1; expected 2"),
            std::string::npos);
}

}  // namespace
}  // namespace legwright
