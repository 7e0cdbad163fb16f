// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/floating_root.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <optional>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

const char* const kFloatingFile = "float.xml";
const char* const kSixJoints =
    "<joint name=\"tx\" type=\"slide\" axis=\"1 0 0\"/>\n"
    "      <joint name=\"ty\" type=\"slide\" axis=\"0 1 0\"/>\n"
    "      <joint name=\"tz\" type=\"slide\" axis=\"0 0 1\"/>\n"
    "      <joint name=\"rz\" axis=\"0 0 1\"/>\n"
    "      <joint name=\"ry\" axis=\"0 1 0\"/>\n"
    "      <joint name=\"rx\" axis=\"1 0 0\"/>";

/// A box on two legs of one hinge, with `joints` for a root and `more` behind the bodies.
std::string floating(const std::string& joints, const std::string& more = "") {
  return "<mujoco>\n  <worldbody>\n    <body name=\"trunk\" pos=\"0 0 0.3\">\n      " + joints +
         "\n      <geom name=\"box\" type=\"box\" size=\"0.1 0.1 0.05\"/>\n"
         "      <body name=\"left\" pos=\"0 0.1 0\">\n        <joint name=\"l\" axis=\"0 1 0\"/>\n"
         "        <geom name=\"lg\" size=\"0.02\" pos=\"0 0 -0.2\"/>\n      </body>\n"
         "      <body name=\"right\" pos=\"0 -0.1 0\">\n        <joint name=\"r\" axis=\"0 1 "
         "0\"/>\n"
         "        <geom name=\"rg\" size=\"0.02\" pos=\"0 0 -0.2\"/>\n      </body>\n    </body>\n"
         "  </worldbody>\n" +
         more + "</mujoco>\n";
}

std::string with_free(const std::string& text) {
  const RobotFiles files = RobotFiles::from_text(text, kFloatingFile);
  const auto root = find_six_joint_root(files.text(), files.file());
  return root ? with_free_root(files, *root).main_text() : "";
}

/// Places of all geoms and velocities of all bodies in the first keyframe.
struct SeenAtKey {
  Eigen::MatrixXd places, velocities;
};

SeenAtKey seen_at_key(const std::string& text) {
  const ModelPointer model = compile_mjcf(text, kFloatingFile);
  const DataPointer data(mj_makeData(model.get()));
  mj_resetDataKeyframe(model.get(), data.get(), 0);
  mj_forward(model.get(), data.get());
  SeenAtKey out{Eigen::MatrixXd(3, model->ngeom), Eigen::MatrixXd(6, model->nbody)};
  for (int g = 0; g < model->ngeom; ++g) out.places.col(g) = vector_at(data->geom_xpos, g);
  for (int b = 0; b < model->nbody; ++b)
    mj_objectVelocity(model.get(), data.get(), mjOBJ_XBODY, b, out.velocities.col(b).data(), 0);
  return out;
}

TEST(FloatingRoot, SixJointsBecomeAFreeOneAndAllElseStays) {
  std::string wanted = floating(kSixJoints);
  for (std::size_t at = wanted.find("<joint name=\"tx\""); at < wanted.find("<geom name=\"box\"");
       at = wanted.find("<joint", at + 12)) {
    wanted.insert(wanted.find("/>", at) + 2, " -->");
    wanted.insert(at, "<!-- ");
  }
  wanted.insert(wanted.find("<!-- <joint"), "<freejoint name=\"root\"/> ");
  EXPECT_EQ(with_free(floating(kSixJoints)), wanted);
  const auto root = find_six_joint_root(floating(kSixJoints), kFloatingFile);
  ASSERT_TRUE(root.has_value());
  EXPECT_EQ(root->body, "trunk");
  EXPECT_EQ(root->joints, (std::vector<std::string>{"tx", "ty", "tz", "rz", "ry", "rx"}));
}

TEST(FloatingRoot, ANameThatIsTakenIsNotTakenAgain) {
  std::string taken = floating(kSixJoints);
  taken.replace(taken.find("\"l\""), 3, "\"root\"");
  EXPECT_NE(with_free(taken).find("<freejoint name=\"root_\"/>"), std::string::npos);
}

TEST(FloatingRoot, KeyframesShowTheSameRobotAtTheSameVelocity) {
  const std::string keys =
      "  <keyframe>\n    <key name=\"home\" qpos=\"0.4 -0.3 0.1 0.7 -0.4 0.2 0.3 -0.5\" "
      "qvel=\"1 2 -0.5 0.3 0.7 -1.1 2 3\"/>\n  </keyframe>\n";
  const SeenAtKey was = seen_at_key(floating(kSixJoints, keys)),
                  is = seen_at_key(with_free(floating(kSixJoints, keys)));
  EXPECT_LT((is.places - was.places).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((is.velocities - was.velocities).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_GT(was.velocities.norm(), 1.0);
}

TEST(FloatingRoot, OtherRootsStayAsTheyAre) {
  std::string flat = kSixJoints;  // all hinges about one axis
  for (const char* axis : {"\"rz\" axis=\"0 0 1\"", "\"ry\" axis=\"0 1 0\""})
    flat.replace(flat.find(axis) + 11, 5, "1 0 0");
  EXPECT_EQ(with_free(floating(flat)), "");
  const std::string five = std::string(kSixJoints).substr(0, std::string(kSixJoints).rfind('\n'));
  EXPECT_EQ(with_free(floating(five)), "");
  EXPECT_EQ(with_free(floating("<freejoint/>")), "");
  EXPECT_EQ(with_free(floating("")), "");
  const std::string file = test::read_file(test::source_path("tests/robots/strider/robot.xml"));
  EXPECT_FALSE(find_six_joint_root(file, kFloatingFile).has_value());
}

TEST(FloatingRoot, WhatNamesOneOfTheSixIsToldWithItsLine) {
  const std::string more =
      "  <actuator>\n    <motor name=\"lift\" joint=\"tz\"/>\n    <motor name=\"m\" joint=\"l\"/>\n"
      "  </actuator>\n  <sensor>\n    <jointpos name=\"height\" joint=\"tz\"/>\n  </sensor>\n  "
      "<custom>\n"
      "    <tuple name=\"t\"><element objtype=\"joint\" objname=\"rx\"/></tuple>\n  </custom>\n";
  try {
    with_free(floating(kSixJoints, more));
    FAIL() << "an actuator on the root was accepted";
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("float.xml:22: motor 'lift': attribute joint: names 'tz'"),
              std::string::npos)
        << said;
    EXPECT_NE(said.find("jointpos 'height'"), std::string::npos) << said;
    EXPECT_NE(said.find("attribute objname: names 'rx'"), std::string::npos) << said;
    EXPECT_EQ(said.find("motor 'm'"), std::string::npos) << said;
  }
}

TEST(FloatingRoot, JointsInAFrameAreThoseOfItsBody) {
  const std::string framed = "<frame>" + std::string(kSixJoints) + "</frame>";
  EXPECT_NE(with_free(floating(framed)).find("<frame><freejoint"), std::string::npos);
}

TEST(FloatingRoot, ACommentInAJointEndsNoComment) {
  std::string joints = kSixJoints;
  joints.replace(joints.find("/>"), 2, ">\n<!-- travel --></joint>");
  const std::string given = floating(joints), made = with_free(given);
  EXPECT_EQ(std::count(made.begin(), made.end(), '\n'),
            std::count(given.begin(), given.end(), '\n'));
  EXPECT_NO_THROW((void)compile_mjcf(made, kFloatingFile));
}

/// A fault below the six is told with the line that it has in the file as it was.
TEST(FloatingRoot, LinesStayWhereTheyWere) {
  const std::string more =
      "  <custom>\n    <numeric name=\"legwright/x\" data=\"1\"/>\n  </custom>\n";
  const std::string given = floating(kSixJoints, more), made = with_free(given);
  const auto line = [](const std::string& text) {
    return std::count(text.begin(), text.begin() + static_cast<long>(text.find("legwright/x")),
                      '\n');
  };
  EXPECT_EQ(line(made), line(given));
}

TEST(FloatingRoot, ARobotThatIsReadAsItIsNamesTheCure) {
  try {
    (void)parse_robot(floating(kSixJoints), kFloatingFile);
    FAIL() << "a root of six joints was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("legwright init ROBOT.xml -o NEW.xml puts a free"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace legwright
