// SPDX-License-Identifier: Apache-2.0
#include "tools/adopt/studied_robot.hpp"

#include <gtest/gtest.h>

#include "mjcf/read/read_robot.hpp"
#include "tests/support/paths.hpp"

namespace legwright {
namespace {

std::filesystem::path robot(const char* file) {
  return std::filesystem::path(test::source_dir()) / "tests/robots" / file;
}

bool has(const std::vector<std::string>& sentences, const std::string& part) {
  for (const std::string& sentence : sentences)
    if (sentence.find(part) != std::string::npos) return true;
  return false;
}

TEST(StudiedRobot, TellsThePoseThatItGetsAndWhatMayBeAMistake) {
  const StudiedRobot studied = study_robot(robot("wader/robot.xml"));
  ASSERT_TRUE(studied.pose);
  const std::vector<std::string> told = told_of(studied);
  EXPECT_TRUE(has(told, studied.pose->why));
  EXPECT_TRUE(has(told, "3 mm off"));
}

TEST(StudiedRobot, DeclaresSomeOfWhatIsProposed) {
  const StudiedRobot studied = study_robot(robot("wader/robot.xml"));
  ASSERT_GT(studied.found.proposals.size(), 2U);
  const std::vector<Proposal> two(studied.found.proposals.begin(),
                                  studied.found.proposals.begin() + 2);
  const RobotModel model = parse_robot(with_declared(studied, two));
  ASSERT_EQ(model.space.size(), 2);
  for (const int k : {0, 1}) EXPECT_GE(model.space.find(two[static_cast<std::size_t>(k)].name), 0);
}

TEST(StudiedRobot, OfAUrdfIsTheMjcfOfIt) {
  const StudiedRobot studied = study_robot(robot("hound/robot.urdf"));
  EXPECT_TRUE(studied.of_urdf);
  EXPECT_TRUE(has(told_of(studied), "has no mass and is left out"));
  EXPECT_NE(studied.files.main_text().find("<mujoco"), std::string::npos);
}

}  // namespace
}  // namespace legwright
