// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/two_legs_up.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <tuple>

#include "mjcf/propose/standing_pose.hpp"
#include "mjcf/propose/trunk_axes.hpp"
#include "mjcf/read/read_robot.hpp"
#include "tests/mjcf/robots/flat_biped.hpp"
#include "tests/mjcf/robots/robots.hpp"

namespace legwright {
namespace {

const char* const kBipedFile = "biped.xml";

/// A biped with straight legs and without a keyframe, all that stands in its trunk turned.
RobotFiles drawn_lying(const std::array<double, 4>& frame,
                       std::string upright = test::flat_biped()) {
  const std::size_t from = upright.find("  <keyframe>");
  upright.erase(from, upright.find("</keyframe>") + 11 - from);
  return with_upright_axes(RobotFiles::from_text(upright, kBipedFile), {"", frame, false, false});
}

std::optional<TrunkAxes> axes_in(const RobotFiles& files) {
  return find_trunk_axes(files.text(), files.file());
}

TEST(TwoLegsUp, ABipedDrawnLyingIsTurnedUprightAlongEachAxis) {
  using Quat = std::array<double, 4>;
  for (const auto& [lying, up] :
       {std::tuple{Quat{1, -1, 0, 0}, "y is up"}, std::tuple{Quat{1, 1, 0, 0}, "-y is up"},
        std::tuple{Quat{1, 0, 1, 0}, "x is up"}, std::tuple{Quat{1, 0, -1, 0}, "-x is up"}}) {
    const RobotFiles drawn = drawn_lying(lying);
    const auto axes = axes_in(drawn);
    ASSERT_TRUE(axes) << up;
    EXPECT_EQ(axes->why.find(up), 0U) << axes->why;
    EXPECT_NE(axes->why.find("its 2 feet"), std::string::npos) << axes->why;
    const RobotFiles upright = with_upright_axes(drawn, *axes);
    EXPECT_FALSE(axes_in(upright));
    const auto pose = find_standing_pose(upright.text(), kBipedFile);
    const RobotModel robot = parse_robot(
        pose ? with_keyframe(upright.text(), kBipedFile, *pose) : upright.text(), kBipedFile);
    EXPECT_EQ(robot.morphology.foot_count(), 2);
    EXPECT_EQ(robot.morphology.joint_count(), 12);
  }
}

TEST(TwoLegsUp, OnesThatStandOrSayTooLittleAreTakenAsDrawn) {
  EXPECT_FALSE(axes_in(drawn_lying({1, 0, 0, 0})));
  const std::string biped = test::flat_biped();
  // Level legs, and a trunk that is nowhere above the hips, or hangs below them: it may sit.
  for (const char* com : {"0.02 0 -0.05", "0.3 0 0.1", "0.02 0 -0.3"})
    EXPECT_FALSE(
        axes_in(drawn_lying({1, -1, 0, 0}, test::with(biped, "pos=\"0.02 0 0.1\"",
                                                      "pos=\"" + std::string(com) + "\""))))
        << com;
  // Something reaches lower than the feet.
  EXPECT_FALSE(axes_in(drawn_lying(
      {1, -1, 0, 0}, test::with(biped, "<freejoint/>",
                                "<freejoint/><geom name=\"tail\" size=\"0.01\" mass=\"0\" "
                                "pos=\"-0.3 0 -0.8\"/>"))));
}

/// Legs that step about no line through the hips bend elsewhere than they hang.
TEST(TwoLegsUp, ALegWithoutAHingeAcrossTellsNothing) {
  std::string biped = test::flat_biped();
  for (std::size_t at; (at = biped.find("axis=\"0 1 0\"")) != std::string::npos;)
    biped.replace(at, 12, "axis=\"1 0 0\"");
  EXPECT_FALSE(axes_in(drawn_lying({1, -1, 0, 0}, biped)));
}

TEST(TwoLegsUp, TheExamplesStand) {
  const std::string biped = test::example_robot("biped");
  EXPECT_FALSE(find_trunk_axes(biped, kBipedFile));
}

}  // namespace
}  // namespace legwright
