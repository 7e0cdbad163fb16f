// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/trunk_axes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "mjcf/propose/proposals.hpp"
#include "mjcf/propose/standing_pose.hpp"
#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

const char* const kFile = "strider.xml";

std::string strider() {
  return test::read_file(test::source_path("tests/robots/strider/robot.xml"));
}

std::string without_keyframe(std::string xml) {
  const std::size_t from = xml.find("  <keyframe>");
  return xml.erase(from, xml.find("</keyframe>") + 11 - from);
}

RobotFiles files_of(const std::string& text) { return RobotFiles::from_text(text, kFile); }

std::optional<TrunkAxes> axes_of(const RobotFiles& files) {
  return find_trunk_axes(files.text(), files.file());
}

/// Where all geoms are, and what the bodies weigh, is as in strider's own file.
void expect_strider(const std::string& xml, double trunk_height) {
  const ModelPointer is = compile_mjcf(xml, kFile), was = compile_mjcf(strider(), kFile);
  const auto at_home = [&](const mjModel& model) {
    std::vector<mjtNum> qpos(home_qpos(model), home_qpos(model) + model.nq);
    std::copy(home_qpos(*was) + 7, home_qpos(*was) + was->nq, qpos.begin() + 7);
    qpos[2] = trunk_height;
    return kinematics_at(model, qpos.data(), kFile);
  };
  const DataPointer found = at_home(*is), wanted = at_home(*was);
  ASSERT_EQ(is->ngeom, was->ngeom);
  for (int g = 0; g < is->ngeom; ++g)
    EXPECT_LT((vector_at(found->geom_xpos, g) - vector_at(wanted->geom_xpos, g)).norm(), 1e-9) << g;
  for (int b = 1; b < is->nbody; ++b) {
    EXPECT_LT((vector_at(found->xipos, b) - vector_at(wanted->xipos, b)).norm(), 1e-9) << b;
    const auto moments = [b](const mjModel& model, const mjData& data) {
      const Eigen::Matrix3d axes = matrix_at(data.ximat, b);
      return Eigen::Matrix3d(axes * vector_at(model.body_inertia, b).asDiagonal() *
                             axes.transpose());
    };
    EXPECT_LT((moments(*is, *found) - moments(*was, *wanted)).norm(), 1e-9) << b;
  }
}

TEST(TrunkAxes, OfTheRobotsHereHaveZUp) {
  for (const auto& file : test::taken_robots())
    EXPECT_FALSE(axes_of(RobotFiles::read(file))) << file;
  for (const char* name : {"puppy", "biped", "hexapod", "quadruped", "printed_quadruped"})
    EXPECT_FALSE(axes_of(
        RobotFiles::read(test::source_path(std::string("examples/") + name + "/robot.xml"))))
        << name;
}

TEST(TrunkAxes, OfAHexapodDrawnOnItsSideAreTurned) {
  const RobotFiles drawn = files_of(without_keyframe(test::strider_with_y_up()));
  const auto axes = axes_of(drawn);
  ASSERT_TRUE(axes);
  EXPECT_EQ(axes->frame, (std::array<double, 4>{1, 1, 0, 0}));
  EXPECT_FALSE(axes->stands);
  EXPECT_EQ(axes->why.find("y is up in the frame of the trunk 'body': its 6 feet"), 0U)
      << axes->why;
  const RobotFiles upright = with_upright_axes(drawn, *axes);
  EXPECT_FALSE(axes_of(upright));
  expect_strider(upright.text(), 0.115267);
  const ProposedParameters found = propose_parameters(
      with_keyframe(upright.text(), kFile, find_standing_pose(upright.text(), kFile).value()),
      kFile);
  EXPECT_EQ(found.not_standing, "");
  EXPECT_EQ(found.limbs.size(), 6U);
  EXPECT_TRUE(std::any_of(found.proposals.begin(), found.proposals.end(),
                          [](const Proposal& p) { return p.name == "body_length"; }));
}

/// A hexapod that a file without keyframe draws with its legs stretched out level to both sides.
std::string drawn_flat(double half_width) {
  std::string legs;
  for (const auto& [name, x, side] :
       {std::tuple{"fl", .3, 1}, std::tuple{"fr", .3, -1}, std::tuple{"ml", 0., 1},
        std::tuple{"mr", 0., -1}, std::tuple{"hl", -.3, 1}, std::tuple{"hr", -.3, -1}})
    legs += fmt::format(
        R"(<body pos="{1} {2} 0" euler="0 0 {3}"><joint name="{0}_yaw" axis="0 0 1"/>
        <inertial pos="0 0 0" mass=".1" diaginertia="1e-4 1e-4 1e-4"/>
        <body><joint name="{0}_lift" axis="0 1 0"/>
        <inertial pos=".1 0 0" mass=".1" diaginertia="1e-4 5e-4 5e-4"/>
        <body pos=".2 0 0"><joint name="{0}_knee" axis="0 1 0"/>
        <inertial pos=".1 0 0" mass=".1" diaginertia="1e-4 5e-4 5e-4"/>
        <geom size=".02" pos=".2 0 0"/></body></body></body>)",
        name, x, side * half_width, 90 * side);
  return fmt::format(R"(<mujoco><worldbody><body name="trunk" pos="0 0 .3"><freejoint/>
                     <geom type="box" size=".3 {} .03" mass="4"/>)",
                     half_width) +
         legs + "</body></worldbody></mujoco>";
}

TEST(TrunkAxes, OfAWideHexapodDrawnFlatHaveZUp) {
  for (const double half_width : {0.05, 0.2})  // a wide one's other legs hang higher on its side
    EXPECT_FALSE(axes_of(files_of(drawn_flat(half_width)))) << half_width;
}

TEST(TrunkAxes, AreFoundAlongEachDirection) {
  using Quat = std::array<double, 4>;
  for (const auto& [frame, inertial, up, turn] :
       {std::tuple{"1 1 0 0", R"(pos="0 -0.01 0" diaginertia="0.00562 0.02312 0.0185")", "-y",
                   Quat{1, -1, 0, 0}},
        std::tuple{"1 0 1 0", R"(pos="0.01 0 0" diaginertia="0.02312 0.0185 0.00562")", "x",
                   Quat{1, 0, -1, 0}},
        std::tuple{"1 0 -1 0", R"(pos="-0.01 0 0" diaginertia="0.02312 0.0185 0.00562")", "-x",
                   Quat{1, 0, 1, 0}}}) {
    const RobotFiles drawn = files_of(without_keyframe(test::strider_in_axes(frame, inertial)));
    const auto axes = axes_of(drawn);
    ASSERT_TRUE(axes) << up;
    EXPECT_EQ(axes->why.find(std::string(up) + " is up"), 0U) << axes->why;
    EXPECT_EQ(axes->frame, turn) << up;
    expect_strider(with_upright_axes(drawn, *axes).text(), 0.115267);
  }
}

/// As a CAD program with y up draws legs that reach out: no pose of it stands with z up.
TEST(TrunkAxes, OfLegsThatReachOutAreThoseOfTheirFirstHinges) {
  std::string xml = drawn_flat(0.2);
  EXPECT_FALSE(find_lying_trunk_axes(xml, kFile)) << "lies as it should";
  xml.insert(xml.find("<freejoint/>") + 12, "<frame quat=\"1 -1 0 0\">");
  xml.insert(xml.rfind("</body>"), "</frame>");
  EXPECT_FALSE(axes_of(files_of(xml)));
  const auto axes = find_lying_trunk_axes(xml, kFile);
  ASSERT_TRUE(axes);
  EXPECT_EQ(axes->why.find("y seems to be up"), 0U) << axes->why;
  EXPECT_EQ(axes->frame, (std::array<double, 4>{1, 1, 0, 0}));
  // Legs that hang side by side say nothing: their first hinges may turn about any axis.
  EXPECT_FALSE(find_lying_trunk_axes(without_keyframe(test::strider_with_y_up()), kFile));
}

/// z is up, but x looks between two legs: what stands in the trunk is turned, the robot is not.
TEST(TrunkAxes, ThatAreAskewToTheHipsAreTurnedAboutZ) {
  const char* const inertial = R"(pos="0 0 .01" quat="12 0 0 5" diaginertia=".00562 .0185 .02312")";
  const std::string xml = test::with(test::strider_in_axes("12 0 0 5", inertial),
                                     "0 0 0.115267 1 0 0 0 ", "0 0 0.115267 12 0 0 -5 ");
  const auto axes = axes_of(files_of(xml));
  ASSERT_TRUE(axes);
  EXPECT_TRUE(axes->upright);
  EXPECT_NE(axes->why.find("is turned by 44.8 degrees about z"), std::string::npos) << axes->why;
  const std::string turned = with_upright_axes(files_of(xml), *axes).text();
  expect_strider(turned, 0.115267);
  EXPECT_FALSE(axes_of(files_of(turned)));
}

TEST(TrunkAxes, AllOtherBytesStay) {
  std::string windows;
  for (const char c : without_keyframe(test::strider_with_y_up()))
    windows += c == '\n' ? "\r\n" : std::string(1, c);
  const RobotFiles drawn = files_of(windows);
  std::string text = with_upright_axes(drawn, axes_of(drawn).value()).text();
  for (const auto& [now, before] :
       {std::pair{"<frame quat=\"1 1 0 0\">\r\n", ""},
        std::pair{"\r\n</frame></body>\r\n  </worldbody>", "</body>\r\n  </worldbody>"},
        std::pair{"pos=\"0 0 0.01\" diaginertia=\"0.00562 0.0185 0.02312\"",
                  "pos=\"0 0.01 0\" diaginertia=\"0.00562 0.02312 0.0185\""}})
    text = test::with(text, now, before);
  EXPECT_EQ(text, windows);
}

/// A keyframe, or the trunk's own quat, turns the axes so that the robot stands.
TEST(TrunkAxes, ThatAKeyframeTurnsUprightAreTurnedThereToo) {
  const std::string xml = test::with(test::strider_with_y_up(), "0 0 0.115267 1 0 0 0 ",
                                     "0 0 0.115267 0.5 0.5 0.5 0.5 ");
  const auto axes = axes_of(files_of(xml));
  ASSERT_TRUE(axes);
  EXPECT_TRUE(axes->stands);
  EXPECT_EQ(axes->frame, (std::array<double, 4>{1, 1, 1, 1})) << "it faces on as it stands there";
  const RobotFiles upright = with_upright_axes(files_of(xml), *axes);
  EXPECT_NE(upright.text().find("qpos=\"0 0 0.115267 1 0 0 0 "), std::string::npos);
  EXPECT_FALSE(find_standing_pose(upright.text(), kFile)) << "its keyframe holds";
  const ModelPointer is = compile_mjcf(upright.text(), kFile), was = compile_mjcf(xml, kFile);
  const DataPointer found = kinematics_at(*is, home_qpos(*is), kFile),
                    wanted = kinematics_at(*was, home_qpos(*was), kFile);
  for (int g = 0; g < is->ngeom; ++g)
    EXPECT_LT((vector_at(found->geom_xpos, g) - vector_at(wanted->geom_xpos, g)).norm(), 1e-9) << g;
}

TEST(TrunkAxes, OfATrunkInAnIncludedFileAreToldHowToTurn) {
  const test::TemporaryFolder folder;
  const auto main = folder.path() / "main.xml";
  const std::string xml = without_keyframe(test::strider_with_y_up());
  const std::size_t from = xml.find("<body name=\"body\""), end = xml.find("</worldbody>");
  test::put(folder.path() / "body.xml",
            "<mujocoinclude>" + xml.substr(from, end - from) + "</mujocoinclude>");
  test::put(main, xml.substr(0, from) + "<include file=\"body.xml\"/>" + xml.substr(end));
  const RobotFiles drawn = RobotFiles::read(main);
  const auto axes = axes_of(drawn);
  ASSERT_TRUE(axes);
  try {
    with_upright_axes(drawn, *axes);
    FAIL() << "its trunk is not in main.xml";
  } catch (const InputError& error) {
    for (const char* part : {"main.xml: body 'body'", "y is up", "expected z",
                             "the trunk is not in the main file", "<frame quat=\"1 1 0 0\">"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part << error.what();
  }
}

}  // namespace
}  // namespace legwright
