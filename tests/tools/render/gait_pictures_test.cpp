// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>

#include "tests/tools/render/toy_scene.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/render/contact_timeline.hpp"
#include "tools/render/gait_animation.hpp"
#include "tools/render/strips.hpp"

namespace legwright {
namespace {

/// A toy that walks to the left by 0.2 m a cycle and was simulated 5 cm beside its plan.
GaitClip toy_clip(bool fell = false) {
  GaitClip clip;
  clip.title = "After";
  clip.scene = std::filesystem::path(testing::TempDir()) / "toy_act.xml";
  write_file(clip.scene, kToyScene);
  clip.model = load_drawn_scene(clip.scene);
  clip.plan = blank_trajectory({"left", "right"}, {"L", "R"}, 8, 0.8);
  clip.plan.travel = {0.0, 0.2, 0.0};
  for (int k = 0; k < 8; ++k) {
    clip.plan.at(k, clip.plan.root_column(1)) = 0.025 * k;
    clip.plan.at(k, clip.plan.root_column(2)) = 0.28;
    clip.plan.at(k, clip.plan.target_column(0)) = 0.3 * std::sin(k * 0.785398);
  }
  clip.playback.emplace();
  const double end = fell ? 1.0 : 2.4;
  for (int i = 0; i * 0.1 <= end + 1e-9; ++i) {
    clip.playback->time.push_back(0.1 * i);
    clip.playback->qpos.push_back(clip.planned_at(0.1 * i));
    clip.playback->qpos.back()[0] += 0.05;
  }
  clip.passed = !fell;
  if (fell) clip.fell = 1.0;
  clip.feet = {{"L", {{0.0, 0.4}}, {{0.0, 0.5}, {0.8, end}}}, {"R", {{0.4, 0.9}}, {{0.4, 0.8}}}};
  return clip;
}

int count_of(const Image& image, Rgb colour) {
  int count = 0;
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
    count +=
        image.rgb[i] == colour[0] && image.rgb[i + 1] == colour[1] && image.rgb[i + 2] == colour[2];
  }
  return count;
}

TEST(PoseAt, LiesBetweenTheRecords) {
  const GaitClip clip = toy_clip();
  const auto between = pose_at(*clip.model, *clip.playback, 0.15);
  const auto &before = clip.playback->qpos[1], &after = clip.playback->qpos[2];
  for (std::size_t i = 0; i < between.size(); ++i)
    EXPECT_NEAR(between[i], 0.5 * (before[i] + after[i]), 1e-12) << i;
  EXPECT_EQ(pose_at(*clip.model, *clip.playback, -1.0), clip.playback->qpos.front());
  EXPECT_EQ(pose_at(*clip.model, *clip.playback, 99.0), clip.playback->qpos.back());
}

TEST(LoopFloor, JoinsAfterWholePatterns) {
  const LoopFloor straight = loop_floor({0.0, 0.21}, 0.2);
  EXPECT_EQ(straight.cycles, 1);
  EXPECT_NEAR(straight.stretch[1], 1.05, 1e-12);
  EXPECT_EQ(straight.stretch[0], straight.stretch[1]);
  const LoopFloor slow = loop_floor({0.09, 0.0}, 0.2);  // one cycle is too short for a pattern
  EXPECT_EQ(slow.cycles, 2);
  EXPECT_NEAR(slow.stretch[0], 0.9, 1e-12);
  const LoopFloor slant = loop_floor({0.45, -0.19}, 0.2);
  EXPECT_NEAR(slant.stretch[0], 1.125, 1e-12);
  EXPECT_NEAR(slant.stretch[1], 0.95, 1e-12);
  for (const LoopFloor& as_it_is : {loop_floor({0.02, 0.0}, 0.2), loop_floor({0.3, 0.0}, 0.0)}) {
    EXPECT_EQ(as_it_is.cycles, 1);
    EXPECT_EQ(as_it_is.stretch[0], 1.0);
  }
  EXPECT_EQ(loop_floor({0.0, 0.001}, 0.2).stretch[1], 1.0);  // on the spot
}

TEST(GaitAnimation, LastsItsCyclesAndMoves) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  const GaitClip clip = toy_clip();
  const Animation animation = animate_gait(context, clip);
  ASSERT_EQ(animation.frames.size(), 19U);  // 0.8 s
  EXPECT_EQ(animation.end_ms.back(), 800);
  EXPECT_GT(different_pixels(animation.frames[0], animation.frames[5]), 100);
  EXPECT_EQ(animate_gait(context, clip).frames, animation.frames);
  GaitClip failed = toy_clip(true);  // shows the plan, and says so
  EXPECT_GT(different_pixels(animate_gait(context, failed).frames[0], animation.frames[0]), 50);
}

TEST(OverlayStrip, GhostAndOutlineLieOverTheSimulation) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  std::vector<GaitClip> clips;
  clips.push_back(toy_clip());
  const Image strip = overlay_strip(context, clips);
  clips[0].playback->qpos[16][7] += 0.2;  // start of the last whole cycle, 1.6 s: the simulated leg
  const Image moved = overlay_strip(context, clips);
  EXPECT_GT(different_pixels(strip, moved), 20);
  for (std::size_t i = 0; i < clips[0].playback->qpos.size(); ++i)
    clips[0].playback->qpos[i][0] -= 0.05;  // as planned: the ghost is hidden in the robot
  EXPECT_GT(different_pixels(strip, overlay_strip(context, clips)), 1000);
}

TEST(PhysicsStrip, WhatComesAfterAFallIsPale) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  std::vector<GaitClip> clips;
  clips.push_back(toy_clip(true));
  clips.push_back(toy_clip());
  const Image strip = physics_strip(context, clips);
  const auto darkest = [&](int cell, int row) {
    int least = 255;
    for (int y = 0; y < 190; ++y)
      for (int x = 0; x < 314; ++x)
        least = std::min<int>(least, strip.pixel(8 + cell * 317 + x, 40 + row * 230 + y)[2]);
    return least;
  };
  EXPECT_LT(darkest(1, 0), 100);  // 0.6 s
  EXPECT_GT(darkest(4, 0), 150);  // 2.4 s, it lies since 1 s
  EXPECT_LT(darkest(4, 1), 100);
}

TEST(ContactTimeline, CountsWhatIsCovered) {
  EXPECT_NEAR(covered({{0.0, 1.0}, {2.0, 3.0}}, 0.5, 2.5), 0.5, 1e-12);
  EXPECT_EQ(covered({}, 0.0, 1.0), 0.0);
  const auto all = repeated({{0.5, 1.2}}, 1.0, 2.0);  // the one before reaches into the first cycle
  ASSERT_EQ(all.size(), 3U);
  EXPECT_NEAR(all[0].second, 0.2, 1e-12);
  EXPECT_NEAR(all[2].first, 1.5, 1e-12);
}

TEST(ContactTimeline, TellsTouchInSwingFromStance) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  std::vector<GaitClip> clips;
  clips.push_back(toy_clip());
  Renderer letters(context, *clips[0].model, 64, 48, RenderStyle::cheap);
  const Rgb touches_in_swing{221, 110, 20};
  const Image timeline = contact_timeline(clips, letters);
  EXPECT_EQ(timeline.width, kStripWidth);
  const int wrong = count_of(timeline, touches_in_swing);
  clips[0].feet[0].measured = {{0.0, 0.4}, {0.8, 1.2}, {1.6, 2.0}};
  const int right = count_of(contact_timeline(clips, letters), touches_in_swing);
  EXPECT_GT(wrong, right + 4000);
  const Rgb red{207, 34, 46};
  std::vector<GaitClip> both;
  both.push_back(toy_clip(true));
  both.push_back(toy_clip());
  EXPECT_GT(count_of(contact_timeline(both, letters), red), 200);  // the end of the one that fell
  EXPECT_EQ(count_of(timeline, red), 0);
}

TEST(ContactTimeline, LongNamesOfFeetStandThereWhole) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  std::vector<GaitClip> clips;
  clips.push_back(toy_clip());
  Renderer letters(context, *clips[0].model, 64, 48, RenderStyle::cheap);
  const auto ink_at_the_edge = [&](const std::string& of) {
    for (FootBars& foot : clips[0].feet) foot.name = of;
    const Image timeline = contact_timeline(clips, letters);
    EXPECT_EQ(timeline.width, kStripWidth);
    int count = 0;
    for (int y = 0; y < timeline.height; ++y)
      for (int x = 0; x < 5; ++x) {
        const auto at = static_cast<std::size_t>(3 * (y * timeline.width + x));
        count += timeline.rgb[at] < 250 ? 1 : 0;
      }
    return count;
  };
  EXPECT_EQ(ink_at_the_edge("L"), 0);
  const std::string name = "hoof_front_left";
  EXPECT_GT(letters.text(name).width, 90) << "has no room beside the bars of short names";
  EXPECT_EQ(ink_at_the_edge(name), 0);
}

TEST(Stills, ShowThePhaseAskedFor) {
  LEGWRIGHT_NEEDS_GL();
  const GlContext context;
  std::vector<GaitClip> clips;
  clips.push_back(toy_clip());
  clips.push_back(toy_clip());
  EXPECT_EQ(still(context, clips[0], 0.25).width, 1280);
  const Image pair = still_side_by_side(context, clips, 0.25);
  EXPECT_EQ(pair.width, kStripWidth);
  EXPECT_GT(different_pixels(pair, still_side_by_side(context, clips, 0.75)), 500);
}

}  // namespace
}  // namespace legwright
