// SPDX-License-Identifier: Apache-2.0
#include "tools/render/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mjcf/scene/surroundings.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/render/toy_scene.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/image/png.hpp"
#include "tools/render/iteration_painter.hpp"
#include "tools/render/poses.hpp"
#include "tools/render/posing.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Pixels that differ by more than `least` in a channel.
int different(const Image& a, const Image& b, int least = 8) {
  int count = 0;
  for (std::size_t i = 0; i + 2 < a.rgb.size(); i += 3) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c)
      most = std::max(most, std::abs(a.rgb[i + c] - b.rgb[i + c]));
    count += most > least;
  }
  return count;
}

/// Pixels of the trunk's colour.
int orange(const Image& image, int from = 0, int to = 1 << 20) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = from; x < std::min(image.width, to); ++x) {
      const auto* p = image.pixel(x, y);
      count += p[0] > p[2] + 60;
    }
  }
  return count;
}

TEST(GlContext, ThereIsOneAtATime) {
  LEGWRIGHT_NEEDS_GL();
  {
    const GlContext first;
    EXPECT_NE(first.description().find("llvmpipe"), std::string::npos) << first.description();
    EXPECT_THROW(GlContext(), GlError);
  }
  EXPECT_NO_THROW(GlContext());  // gone with its owner
}

TEST(Renderer, SamePoseIsSameBytes) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const ModelPointer model = toy_model();
  const auto pose = start_pose(*model);
  const View view = frame_robot(*model, {pose}, 120, -15, 320.0 / 240);
  for (const RenderStyle style : {RenderStyle::cheap, RenderStyle::full}) {
    Renderer renderer(context, *model, 320, 240, style);
    const Image first = renderer.render(
        pose, view);  // the first frame too: the infinite floor is centred on the camera
    const Image second = renderer.render(pose, view);
    Renderer fresh(context, *model, 320, 240, style);
    EXPECT_EQ(first, second);
    EXPECT_EQ(first, fresh.render(pose, view));
  }
}

/// Pixels that are nearly black.
int black(const Image& image) {
  int count = 0;
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
    count += std::max({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]}) < 20;
  return count;
}

TEST(Renderer, NoBlackBeyondTheFloorOrAboveTheHorizon) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  std::string scene = kToyScene;
  const std::string floor = R"(size="0 0 0.1")", world = "<worldbody>";
  scene.replace(scene.find(floor), floor.size(), R"(size="3 3 0.1")");
  const std::string skyless = scene;
  scene.insert(scene.find(world),
               R"(<asset><texture type="skybox" builtin="gradient" rgb1="0 0 0" rgb2="0 0 0"
                   width="8" height="48"/></asset>)");
  const auto drawn = [&](const std::string& xml, double elevation) {
    const fs::path file = fs::path(testing::TempDir()) / "floor_scene.xml";
    write_file(file, xml);
    const ModelPointer model = load_drawn_scene(file);
    const auto pose = start_pose(*model);
    const View view = frame_robot(*model, {pose}, 120, elevation, 320.0 / 240);
    return Renderer(context, *model, 320, 240, RenderStyle::full).render(pose, view);
  };
  EXPECT_EQ(black(drawn(scene, -15)), 0);
  EXPECT_EQ(black(drawn(scene, -2)), 0);       // the horizon is in the picture
  EXPECT_GT(black(drawn(skyless, -2)), 1000);  // with nothing to paint on it would be black
}

TEST(Renderer, MovedKneeIsSeen) {  // negative control of the test above
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const ModelPointer model = toy_model();
  const auto pose = start_pose(*model);
  auto moved = pose;
  moved[7] += 0.01;
  const View view = frame_robot(*model, {pose}, 120, -15, 320.0 / 240);
  Renderer renderer(context, *model, 320, 240, RenderStyle::full);
  EXPECT_GT(different(renderer.render(pose, view), renderer.render(moved, view)), 10);
}

TEST(Renderer, RobotFillsThePictureFromAnySide) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const ModelPointer model = toy_model();
  const auto pose = start_pose(*model);
  Renderer renderer(context, *model, 320, 240, RenderStyle::cheap);
  for (const double azimuth : {0.0, 77.0, 200.0, 333.0}) {
    const View view = frame_robot(*model, {pose}, azimuth, -15, 320.0 / 240);
    const Image with = renderer.render(pose, view);
    auto away = pose;
    away[0] += 100.0;
    const int robot = different(with, renderer.render(away, view));
    EXPECT_GT(robot, 320 * 240 / 12) << azimuth;
    EXPECT_LT(robot, 320 * 240 * 8 / 10) << azimuth;
    EXPECT_GT(orange(with), 500) << azimuth;
  }
}

/// By how many rows the trunk's right end is higher than its left one; NaN where it is not in the
/// picture.
double rise(const Image& image) {
  double row[2] = {0.0, 0.0};
  int count[2] = {0, 0};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto* p = image.pixel(x, y);
      if (!(p[0] > p[2] + 60)) continue;
      const int side = x < image.width / 2 ? 0 : 1;
      row[side] += y;
      ++count[side];
    }
  return row[0] / count[0] - row[1] / count[1];
}

TEST(Renderer, OnASlopeUpIsUp) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const ModelPointer level = toy_model(), slope = toy_model();
  slope->opt.gravity[0] = -9.81 * std::sin(0.3);  // the ground rises along +x
  slope->opt.gravity[2] = -9.81 * std::cos(0.3);
  EXPECT_TRUE(ground_rotation(*level).isIdentity(0.0));
  const auto pose = start_pose(*level);
  const auto seen = [&](const mjModel& model) {
    const View view = frame_robot(model, {pose}, 90, -10, 320.0 / 240);
    Renderer renderer(context, model, 320, 240, RenderStyle::cheap);
    return renderer.render(pose, view);
  };
  const Image flat = seen(*level), steep = seen(*slope);
  EXPECT_NEAR(rise(flat), 0.0, 1.0);
  EXPECT_GT(rise(steep), 15.0);                // +x is to the right
  EXPECT_GT(orange(steep), orange(flat) / 2);  // and it is still in the picture, as large as fits
}

TEST(Renderer, RowsStartAtTheTopAndLeftIsLeft) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const ModelPointer model = toy_model();
  auto pose = start_pose(*model);
  Renderer renderer(context, *model, 320, 240, RenderStyle::cheap);
  View view =
      frame_robot(*model, {pose}, 180, -10, 320.0 / 240);  // from the front: +y is to the right
  view.distance *= 2;
  pose[1] += 0.15;
  EXPECT_GT(orange(renderer.render(pose, view), 160),
            4 * orange(renderer.render(pose, view), 0, 160));
  pose[1] -= 0.15;
  pose[2] += 0.25;
  const Image high = renderer.render(pose, view);
  Image top = high;
  top.height = 120;
  EXPECT_GT(orange(top), orange(high) * 9 / 10);
}

TEST(Renderer, RefusesPosesThatAreNone) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const ModelPointer model = toy_model();
  auto pose = start_pose(*model);
  Renderer renderer(context, *model, 64, 48, RenderStyle::cheap);
  const View view = frame_robot(*model, {pose}, 0, 0, 1);
  pose.pop_back();
  EXPECT_THROW(renderer.render(pose, view), std::invalid_argument);
  pose.push_back(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(renderer.render(pose, view), std::invalid_argument);
}

TEST(Renderer, DrawsTextThatCanBeRead) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const ModelPointer model = toy_model();
  Renderer renderer(context, *model, 64, 48, RenderStyle::cheap);
  const auto ink = [](const Mask& mask) {
    int sum = 0;
    for (const auto cover : mask.cover) sum += cover > 128;
    return sum;
  };
  const Mask one = renderer.text("walk"), two = renderer.text("walk walk"),
             none = renderer.text("");
  EXPECT_GT(ink(one), 30);
  EXPECT_EQ(ink(two), 2 * ink(one));
  EXPECT_GT(two.width, 2 * one.width);
  EXPECT_EQ(ink(none), 0);
  EXPECT_GT(ink(renderer.text("walk", true)), ink(one));
  EXPECT_GT(ink(renderer.text(
                "before and after of a long title, longer than the canvas is wide for it", true)),
            200);
}

TEST(StartPose, IsTheGaitsKeyframeNotTheHomeOne) {
  const fs::path file = fs::path(testing::TempDir()) / "two_keys.xml";
  std::string scene = kToyScene;
  const std::size_t at = scene.find("<key ");
  scene.insert(at, "<key name=\"home\" qpos=\"0 0 9 1 0 0 0 0 0\"/>");
  write_file(file, scene);
  EXPECT_EQ(start_pose(*load_drawn_scene(file))[2], 0.28);
  scene.replace(scene.find("name=\"gait\""), 11, "name=\"other\"");
  write_file(file, scene);
  EXPECT_EQ(start_pose(*load_drawn_scene(file))[2], 9.0);
}

TEST(FrameRobot, ShowsAllPosesOfAllRobots) {
  const ModelPointer model = toy_model();
  Poses poses{start_pose(*model), start_pose(*model)};
  const View one = frame_robot(*model, {poses[0]}, 90, 0, 1.0);
  poses[1][0] += 2.0;
  const View both = frame_robot(*model, poses, 90, 0, 1.0);
  EXPECT_NEAR(both.lookat[0] - one.lookat[0], 1.0, 0.05);
  EXPECT_GT(both.distance, 3 * one.distance);
  EXPECT_THROW(frame_robots({}, 0, 0, 1), std::invalid_argument);
}

TEST(IterationPainter, WritesTheSameStillTwice) {
  LEGWRIGHT_NEEDS_GL();
  const test::TemporaryFolder own;  // others write into the common one
  const fs::path folder = own.path();
  write_file(folder / "scene.xml", kToyScene);
  const IterationPainter painter(folder / "scene.xml");
  painter.paint(folder / "scene.xml", folder / "a.png");
  painter.paint(folder / "scene.xml", folder / "b.png");
  EXPECT_EQ(read_file(folder / "a.png"), read_file(folder / "b.png"));
  EXPECT_GT(orange(read_png(folder / "a.png")), 2000);
  EXPECT_THROW(painter.paint(folder / "absent.xml", folder / "c.png"), std::runtime_error);
  EXPECT_FALSE(fs::exists(folder / "c.png"));
}

}  // namespace
}  // namespace legwright
