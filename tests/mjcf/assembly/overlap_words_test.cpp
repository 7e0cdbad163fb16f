// SPDX-License-Identifier: Apache-2.0
// Modules of a robot that stand inside each other, in words of its assembly.
#include "mjcf/assembly/overlap_words.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mjcf/assembly/build_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/assembly/boxy_dog.hpp"

namespace legwright {
namespace {

using test::boxy_dog;

/// As read from a file: lines of part, limb and joints.
Assembly dog_of_a_file() {
  Assembly out = boxy_dog();
  out.parts[0].line = 5;
  out.limbs[0].line = 8;
  out.limbs[0].joints[0].line = 13;
  out.limbs[0].joints[1].line = 14;
  return out;
}

std::vector<std::string> notes_of(const Assembly& assembly) {
  return overlap_notes(assembly, build_robot(assembly, "dog.xml").overlaps);
}

std::string refusal_of(const Assembly& assembly) {
  try {
    refuse_overlaps(assembly, build_robot(assembly, "dog.xml").overlaps, "dog.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(OverlapWords, AreNoneOfADogWhoseHipsStandInItsTray) {
  EXPECT_TRUE(notes_of(dog_of_a_file()).empty());
  EXPECT_EQ(refusal_of(dog_of_a_file()), "");
}

TEST(OverlapWords, TellABatteryInServosOnceForAllFour) {
  Assembly dog = dog_of_a_file();
  dog.parts[0].module.outline[0].size = {0.19, 0.076, 0.02};  // servos begin at y = 0.036
  const std::vector<std::string> notes = notes_of(dog);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "part_1_pack (line 5) stands 2 mm inside FL_hip_servo (line 13) along y at home, the "
            "deepest of 4 such pairs: nobody can put that together; move the part by its position, "
            "or the limb by hip");
  EXPECT_EQ(build_robot(dog, "dog.xml").notes.front(), notes[0]) << "which build tells first";
  EXPECT_EQ(refusal_of(dog), "");
}

/// Which passes otherwise: what is printed has no room for both.
TEST(OverlapWords, RefuseABatteryInServosOfADogThatIsToBePrinted) {
  Assembly dog = dog_of_a_file();
  dog.link_shape = LinkShape::hull;
  dog.print = PrintLimits{};
  EXPECT_EQ(refusal_of(dog), "") << "hips stand in the tray";
  dog.parts[0].module.outline[0].size = {0.19, 0.0728, 0.02};
  EXPECT_EQ(refusal_of(dog), "") << "0.4 mm";
  dog.parts[0].module.outline[0].size = {0.19, 0.0736, 0.02};
  const std::string told = refusal_of(dog);
  EXPECT_TRUE(told.starts_with(
      "dog.toml:5: part.module: part_1_pack would stand 0.8 mm inside FL_hip_servo (line 13) along "
      "y at home, the deepest of 4 such pairs, and [print] asks for parts that hold both; move"))
      << told;
  dog.print.reset();
  EXPECT_EQ(refusal_of(dog), "");
}

TEST(OverlapWords, TellCopiesThatAreTooNear) {
  Assembly dog = dog_of_a_file();
  dog.limbs[0].hip.x() = 0.0305;
  dog.limbs[0].step = {-0.061, 0.0, 0.0};  // of servos that begin 32 mm behind and before
  const std::vector<std::string> notes = notes_of(dog);
  ASSERT_FALSE(notes.empty());
  EXPECT_TRUE(
      notes[0].starts_with("FL_hip_servo (line 13) stands 3 mm inside HL_hip_servo (line "
                           "13) along x at home"))
      << notes[0];
  EXPECT_TRUE(notes[0].ends_with("; lengthen step")) << notes[0];
}

TEST(OverlapWords, RefuseServosInOnePlace) {
  Assembly dog = dog_of_a_file();
  dog.limbs[0].joints[1].offset = {0.0, 0.0, -0.01};
  const std::string told = refusal_of(dog);
  EXPECT_TRUE(told.starts_with("dog.toml:13: limb.joint: FL_hip_servo would stand ")) << told;
  EXPECT_NE(told.find("inside FL_knee_servo (line 14)"), std::string::npos) << told;
  EXPECT_NE(told.find("lengthen offset"), std::string::npos) << told;
}

TEST(OverlapWords, NameTheOtherSideOfALimbThatGoesAcross) {
  Assembly dog = dog_of_a_file();
  dog.limbs[0].hip.y() = -0.02;
  dog.limbs[0].joints[1].offset = {0.0, 0.02, -0.09};
  const std::vector<std::string> notes = notes_of(dog);
  ASSERT_FALSE(notes.empty());
  bool is_told = false;
  for (const std::string& note : notes) {
    is_told = is_told || note.ends_with("give hip y = 0.02");
    EXPECT_FALSE(note.starts_with("trunk")) << "which stays where it is: " << note;
  }
  EXPECT_TRUE(is_told) << notes[0];
}

}  // namespace
}  // namespace legwright
