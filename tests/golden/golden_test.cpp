// SPDX-License-Identifier: Apache-2.0
// Gaits as pictures: stored poses are drawn again and compared with stored pictures.
#include "tests/golden/golden.hpp"

#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/render/toy_scene.hpp"
#include "tools/image/png.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

class Golden : public testing::TestWithParam<std::string> {
 protected:
  static fs::path differences(const std::string& robot, const std::string& file) {
    return fs::path(test::binary_dir()) / "golden_differences" / (robot + "_" + file + ".png");
  }
};

Renderer renderer_of(const GlContext& context, const golden::Robot& robot) {
  return Renderer(context, *robot.model, golden::kWidth, golden::kHeight, RenderStyle::plain);
}

/// Pixels of the third picture that are marked as different.
int marked(const Image& all) {
  int count = 0;
  for (int y = 0; y < all.height; ++y) {
    for (int x = all.width - golden::kWidth; x < all.width; ++x) {
      const auto* p = all.pixel(x, y);
      count += p[0] == 255 && p[1] == 0 && p[2] == 0;
    }
  }
  return count;
}

TEST_P(Golden, GeomsAreSeenWhereTheyWere) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const golden::Robot robot = golden::read_robot(GetParam());
  ASSERT_GE(robot.poses.size(), 3U);
  Renderer renderer = renderer_of(context, robot);
  for (const auto& pose : robot.poses) {
    const std::string message =
        golden::compare(read_id_png(robot.id_file(pose)), renderer.ids(pose.qpos, robot.view),
                        golden::kAllowedPixels, differences(robot.name, pose.name + "_id"));
    EXPECT_EQ(message, "") << robot.name << ", " << pose.name << ": " << message;
  }
}

TEST_P(Golden, ColoursAreTheSameBytesOnThePinnedVersions) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const golden::Versions pinned = golden::read_versions(), here = golden::versions_here(context);
  if (!pinned.cover(here)) {
    GTEST_SKIP() << "NOT TESTED, the colours were stored with " << pinned.text() << "; here is "
                 << here.text();
  }
  const golden::Robot robot = golden::read_robot(GetParam());
  Renderer renderer = renderer_of(context, robot);
  for (const auto& pose : robot.poses) {
    const std::string message =
        golden::compare(read_png(robot.colour_file(pose)), renderer.render(pose.qpos, robot.view),
                        differences(robot.name, pose.name + "_colour"));
    EXPECT_EQ(message, "") << robot.name << ", " << pose.name << ": " << message;
  }
}

TEST_P(Golden, TwinMovedByAHundredthOfARadianFailsAndIsShown) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const golden::Robot robot = golden::read_robot(GetParam());
  Renderer renderer = renderer_of(context, robot);
  const test::TemporaryFolder own;
  for (const auto& pose : robot.poses) {
    const fs::path file = own.path() / "differences" / (pose.name + ".png");
    const IdImage stored = read_id_png(robot.id_file(pose)),
                  moved = renderer.ids(robot.twin(pose, 0.01), robot.view);
    const std::string message = golden::compare(stored, moved, golden::kAllowedPixels, file);
    EXPECT_NE(message, "") << pose.name;
    EXPECT_NE(message.find(file.string()), std::string::npos) << message;
    EXPECT_NE(message.find("golden_tool --write"), std::string::npos) << message;
    const Image shown = read_png(file);
    EXPECT_EQ(shown.height, golden::kHeight);
    EXPECT_GT(shown.width, 3 * golden::kWidth);
    EXPECT_EQ(marked(shown), different_pixels(stored, moved));
    Image before(golden::kWidth, golden::kHeight);
    copy_into(before, shown, 0, 0);
    EXPECT_EQ(before, in_colours(stored));
  }
}

TEST_P(Golden, TwinHasOtherColoursToo) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const golden::Robot robot = golden::read_robot(GetParam());
  Renderer renderer = renderer_of(context, robot);
  const test::TemporaryFolder own;
  const auto& pose = robot.poses.front();
  const fs::path file = own.path() / "colour.png";
  EXPECT_NE(golden::compare(renderer.render(pose.qpos, robot.view),
                            renderer.render(robot.twin(pose, 0.01), robot.view), file),
            "");
  EXPECT_TRUE(fs::exists(file));
}

INSTANTIATE_TEST_SUITE_P(Robots, Golden, testing::ValuesIn(golden::kRobots),
                         [](const auto& robot) { return robot.param; });

TEST(GoldenFiles, StaySmall) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(golden::folder()))
    if (entry.is_regular_file()) bytes += entry.file_size();
  EXPECT_LT(bytes, 1'000'000U);
}

}  // namespace
}  // namespace legwright
