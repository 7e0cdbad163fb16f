// SPDX-License-Identifier: Apache-2.0
#include "tools/assemble/assembly_desk.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "tests/tools/assemble/example_assemblies.hpp"
#include "tools/modules/assembly_text.hpp"

namespace legwright {
namespace {

using test::installed_library;

Json put(const char* module, const char* spot) {
  return {{"do", "put"}, {"module", module}, {"spot", spot}};
}

Json set(const char* item, const char* key, const Json& value, bool goes_on = false) {
  return {{"do", "set"}, {"item", item}, {"key", key}, {"value", value}, {"goes_on", goes_on}};
}

TEST(AssemblyDesk, ATrunkAndSixCommandsAreARobotThatStands) {
  AssemblyDesk desk(installed_library());
  EXPECT_TRUE(desk.now().limbs.empty());
  EXPECT_EQ(desk.obey(put("XL430-W250", "side/front")), "limb/0/joint/0");
  EXPECT_EQ(desk.obey(put("XL430-W250", "limb/0/end")), "limb/0/joint/1");
  desk.obey({{"do", "copy"}, {"item", "limb/0"}, {"spot", "side/hind"}});
  desk.obey(put("lipo_3s_2200", "ride/middle"));
  desk.obey(set("trunk", "name", "made"));
  const BuiltRobot robot = build_robot(desk.now(), "made.xml");
  EXPECT_EQ(robot.found.model.morphology.foot_count(), 4);
  EXPECT_EQ(robot.found.model.morphology.joint_count(), 8);
  EXPECT_TRUE(robot.found.not_standing.empty()) << robot.found.not_standing;
}

TEST(AssemblyDesk, StepsAreUndoneAndDoneAgain) {
  AssemblyDesk desk(installed_library());
  EXPECT_FALSE(desk.can_undo());
  desk.obey(put("XL430-W250", "side/front"));
  for (int k = 1; k <= 5; ++k)
    desk.obey(set("limb/0/foot", "offset", {0.0, 0.0, -0.1 - 0.01 * k}, k > 1));
  EXPECT_NEAR(desk.now().limbs[0].foot_offset.z(), -0.15, 1e-12);
  desk.obey({{"do", "undo"}});
  EXPECT_NEAR(desk.now().limbs[0].foot_offset.z(), -0.09, 1e-12) << "what went on was one step";
  desk.obey({{"do", "undo"}});
  EXPECT_TRUE(desk.now().limbs.empty());
  EXPECT_FALSE(desk.can_undo());
  desk.obey({{"do", "redo"}});
  EXPECT_EQ(desk.now().limbs.size(), 1u);
  desk.obey({{"do", "remove"}, {"item", "limb/0"}});
  EXPECT_FALSE(desk.can_redo()) << "what was undone is another way";
}

TEST(AssemblyDesk, WhatGoesOnTakesNoOlderStepAway) {
  AssemblyDesk desk(installed_library());
  desk.obey(put("XL430-W250", "side/front"));
  desk.obey(set("limb/0", "hip", {0.11, 0.08, 0.0}));
  desk.obey(set("limb/0/foot", "offset", {0.0, 0.0, -0.12}, true));  // another key than before
  desk.obey({{"do", "undo"}});
  EXPECT_EQ(desk.now().limbs[0].hip.x(), 0.11);
  desk.obey(set("limb/0/foot", "offset", {0.0, 0.0, -0.13}, true));  // a hand that went on
  desk.obey({{"do", "undo"}});
  EXPECT_EQ(desk.now().limbs[0].hip.x(), 0.11);
  desk.obey(set("limb/0", "hip", {0.11, 0.08, 0.0}));
  EXPECT_TRUE(desk.can_redo()) << "what changes nothing is no step";
}

TEST(AssemblyDesk, AHandThatComesBackOrDoesNotMoveIsNoStep) {
  AssemblyDesk desk(installed_library());
  desk.obey(put("XL430-W250", "side/front"));
  const auto drag = [&](double z, bool goes_on) {
    desk.obey(set("limb/0/foot", "offset", {0.0, 0.0, z}, goes_on));
  };
  drag(-0.10, false);
  drag(-0.10, false);  // another hand, which has not moved yet,
  drag(-0.12, true);
  desk.obey({{"do", "undo"}});
  EXPECT_EQ(desk.now().limbs[0].foot_offset.z(), -0.10) << "took nothing of the step before";
  desk.obey({{"do", "redo"}});
  drag(-0.13, false);
  drag(-0.14, true);
  drag(-0.12, true);  // back where it began
  EXPECT_FALSE(desk.can_redo());
  desk.obey({{"do", "undo"}});
  EXPECT_EQ(desk.now().limbs[0].foot_offset.z(), -0.10) << "as if it had not been there";
}

TEST(AssemblyDesk, RefusalsNameNoLineOfAFileThatNobodyHas) {
  AssemblyDesk desk(installed_library());
  desk.obey(put("XL430-W250", "side/front"));
  try {
    desk.obey(set("limb/0/joint/0", "name", "two words"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("limb.joint.")) << error.what();
    EXPECT_NE(std::string(error.what()).find("is \"two words\""), std::string::npos);
  }
}

TEST(AssemblyDesk, WhatTheFileCouldNotSayChangesNothing) {
  AssemblyDesk desk(installed_library());
  desk.obey(put("XL430-W250", "side/front"));
  const std::string before = assembly_text(desk.now());
  for (const Json& command :
       {set("limb/0", "names", {"a b"}), set("limb/0/joint/0", "axis", {0, 0, 0}),
        set("limb/0/joint/0", "range", {1.0, -1.0}), set("limb/0/foot", "offset", {0, 0, 0}),
        put("XL430", "limb/0/end"), Json{{"do", "dance"}}, Json::array(), Json{{"do", 3}}})
    EXPECT_THROW(desk.obey(command), InputError) << command;
  EXPECT_EQ(assembly_text(desk.now()), before);
}

TEST(AssemblyDesk, ADraftHasNoLimbAndItsFirstTheSmallestBall) {
  AssemblyDesk desk("[trunk]\nmodule = \"plate_200x100\"\n", "x.toml", installed_library());
  desk.obey(put("XL430-W250", "side/front"));
  EXPECT_EQ(desk.now().limbs[0].foot.name, "ball_foot_8");
}

}  // namespace
}  // namespace legwright
