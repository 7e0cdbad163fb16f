// SPDX-License-Identifier: Apache-2.0
// Legs of two hinges, the first about the vertical: their knees bend them outwards.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mjcf/propose/facing.hpp"
#include "mjcf/propose/proposals.hpp"
#include "mjcf/propose/standing_pose.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

const char* const kCrawlerFile = "crawler.xml";

/// Legs beside a long trunk, or beside segments that a waist joins, drawn straight out sideways.
/// @param axis of the hips on the right; those on the left turn about +z
std::string level_crawler(int rows, const std::string& axis, bool has_waist) {
  std::string bodies, ends, servos;
  const auto drive = [&](const std::string& joint) {
    servos += fmt::format(R"(<position joint="{}" kp="400" forcerange="-150 150"/>)", joint);
  };
  for (int row = 0; row < rows; ++row) {
    const double x = has_waist ? 0.0 : -0.5 * row;
    if (row > 0 && has_waist) {
      bodies += fmt::format(
          R"(<body name="part{0}" pos="-0.5 0 0"><joint name="waist{0}" axis="0 0 1" pos="0.25 0 0"
          range="-20 20"/><geom type="sphere" size="0.2"/>)",
          row);
      ends += "</body>";
      drive(fmt::format("waist{}", row));
    }
    for (const int side : {1, -1}) {
      bodies += fmt::format(
          R"(<body name="leg{0}{1}" pos="{2} {3} 0"><joint name="hip{0}{1}" axis="{4}"
          range="-40 40"/><geom type="capsule" size="0.05" fromto="0 0 0 0 {3} 0"/>
          <body name="shin{0}{1}" pos="0 {3} 0"><joint name="knee{0}{1}" axis="{5} 0 0"
          range="30 100"/><geom type="capsule" size="0.05" fromto="0 0 0 0 {6} 0"/></body></body>)",
          row, side > 0 ? "a" : "b", x, 0.28 * side, side > 0 ? "0 0 1" : axis, -side, 0.6 * side);
      for (const char* joint : {"hip", "knee"})
        drive(fmt::format("{}{}{}", joint, row, side > 0 ? "a" : "b"));
    }
  }
  return R"(<mujoco><default><geom density="200"/></default><worldbody><body name="trunk"
      pos="0 0 0.7"><freejoint/><geom type="sphere" size="0.2"/>)" +
         bodies + ends + "</body></worldbody><actuator>" + servos + "</actuator></mujoco>";
}

/// Whether hips on the left and right turn about one line or mirrored ones, their feet mirror each
/// other; hips stay amid their ranges.
TEST(LevelLegs, StandBesideTheirHipsMirrored) {
  for (const char* const axis : {"0 0 1", "0 0 -1"})
    for (const bool has_waist : {false, true}) {
      const std::string xml = level_crawler(3, axis, has_waist);
      const auto pose = find_standing_pose(xml, kCrawlerFile);
      ASSERT_TRUE(pose) << axis << has_waist;
      EXPECT_EQ(pose->words.find("level, feet beside the hips: hip0a 0, knee0a "), 0u)
          << pose->words;
      const ProposedParameters found =
          propose_parameters(with_keyframe(xml, kCrawlerFile, *pose), kCrawlerFile);
      for (const Limb& limb : found.limbs) EXPECT_GE(limb.partner, 0) << axis << has_waist;
    }
}

/// Hips of legs on a waist hang where they are, not where the feet stand: here in two rows along x,
/// while feet are nearer to each other along x than along y.
TEST(LevelLegs, OfAWaistTellWhereTheRobotFaces) {
  std::string xml = level_crawler(4, "0 0 -1", true);
  std::string qpos = "0 0 0.6 1 0 0 0";
  for (int row = 0; row < 4; ++row)
    qpos += fmt::format("{} {} 1 {} 1", row > 0 ? " 0" : "", row < 2 ? -0.58 : 0.58,
                        row < 2 ? -0.58 : 0.58);
  xml.insert(xml.find("<actuator>"),
             "<keyframe><key name=\"home\" qpos=\"" + qpos + "\"/></keyframe>");
  const Facing facing = facing_of(parse_robot(xml, kCrawlerFile));
  EXPECT_EQ(facing.ahead, Eigen::Vector2d(1, 0));
  EXPECT_EQ(facing.remark, "");
}

}  // namespace
}  // namespace legwright
