// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/mjcf_words.hpp"

#include <gtest/gtest.h>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/support/text.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

/// What the puppy is refused with after a change.
std::string told_of_puppy(const std::string& old_part, const std::string& new_part) {
  try {
    parse_robot(test::with(test::read_file(test::puppy_file()), old_part, new_part), "robot.xml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MjcfWords, KnowThoseOfEachRobot) {
  for (const auto& file : test::taken_robots())
    EXPECT_TRUE(unknown_words(*load_xml(test::read_file(file), file)).empty()) << file;
}

TEST(MjcfWords, ThatAreUnknownAreToldAllAtOnceWithThoseMeant) {
  std::string xml = test::read_file(test::puppy_file());
  xml = test::with(xml, "<joint type=\"hinge\" axis", "<joint type=\"hinge\" axs");
  xml =
      test::with(xml, "<geom type=\"capsule\" size=\"0.025\"", "<goem type=\"capsule\" size=\"1\"");
  xml = test::with(xml, "<material name=\"lid\"", "<paint name=\"lid\"");
  try {
    parse_robot(xml, "robot.xml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(in_order(
        error.what(),
        {"robot.xml:18: joint: attribute axs", "did you mean 'axis'?", "robot.xml:21: goem",
         "did you mean 'geom'?", "robot.xml:40: paint 'lid'", "no element of MJCF; remove"}));
  }
}

TEST(MjcfWords, HideNothingElseThatIsWrong) {
  std::string xml = test::read_file(test::puppy_file());
  xml =
      test::with(xml, "<geom type=\"capsule\" size=\"0.025\"", "<goem type=\"capsule\" sise=\"1\"");
  xml = test::with(xml, "<joint type=\"hinge\" axis", "<joint type=\"hinge\" colour=\n\"a\" axs");
  xml = test::with(xml, "class=\"foot\"", "class=\"feet\"");
  const auto read = load_xml(xml, "robot.xml");
  EXPECT_EQ(count_of(with_known_words(*read), "\n"), count_of(xml, "\n"));
  EXPECT_EQ(unknown_words(*load_xml(with_known_words(*read), "robot.xml")).all().size(), 0u);
  try {
    parse_robot(xml, "robot.xml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(in_order(error.what(), {"colour", "'axis'?", "'geom'?", "foot"}));
  }
}

TEST(MjcfWords, OfVeryManyTheFirstAreTold) {
  std::string geoms;
  for (int k = 0; k < 5000; ++k)
    geoms += "<geom size=\"0.1\" colour" + std::to_string(k) + "=\"\"/>\n";
  const auto read = load_xml("<mujoco><worldbody>\n" + geoms + "</worldbody></mujoco>", "many.xml");
  const Refusals told = unknown_words(*read);
  ASSERT_EQ(told.all().size(), 51U);
  EXPECT_TRUE(
      in_order(told.all().back().what(), {"many.xml:5001: geom", "last of 4950 more places"}));
  EXPECT_TRUE(unknown_words(*load_xml(with_known_words(*read), "many.xml")).empty());
}

TEST(MjcfWords, ASlipInTheFreeJointIsNoRobotWithoutOne) {
  EXPECT_TRUE(in_order(told_of_puppy("<freejoint", "<freejoin"),
                       {"freejoin", "did you mean 'freejoint'?"}));
}

TEST(MjcfWords, OfAKnownWordInTheWrongPlaceMujocoTells) {
  EXPECT_TRUE(
      in_order(told_of_puppy("<material name=\"lid\"", "<geom name=\"lid\""),
               {"robot.xml:40: MuJoCo: ", "Schema violation", "opens it without Legwright"}));
}

TEST(CureOfRefusal, TellsWhatMeshesAreRead) {
  const test::TemporaryFolder folder;
  for (const auto& [name, text] : {std::pair{"a.stl", "solid a\nendsolid a\n"},
                                   {"a.msh", "abc"},
                                   {"a.ply", "ply\nformat ascii 1.0\n"}}) {
    test::put(folder.path() / name, text);
    const std::string xml = std::string("<mujoco><asset><mesh file=\"") + name +
                            "\"/></asset><worldbody><body><freejoint/><geom type=\"mesh\" "
                            "mesh=\"a\"/></body></worldbody></mujoco>";
    try {
      compile_mjcf(xml, folder.path() / "robot.xml");
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_TRUE(in_order(error.what(), {name, "as a binary STL", "or as OBJ"}));
    }
  }
}

/// A robot whose contacts name the floor of the scene that includes it.
TEST(MjcfWords, ANameThatIsElsewhereIsLookedForInTheFileAround) {
  try {
    compile_mjcf(
        "<mujoco><worldbody><geom name=\"foot\" size=\"0.1\"/></worldbody><contact>"
        "<pair geom1=\"foot\" geom2=\"floor\"/></contact></mujoco>",
        "robot.xml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a file that includes this one, as a scene"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace legwright
