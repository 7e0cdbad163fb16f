// SPDX-License-Identifier: Apache-2.0
#include "tools/render/strips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

constexpr StripLayout kPhases{8, 196, 176};   // one cycle of the plan
constexpr StripLayout kMoments{5, 314, 190};  // wider, to have the way in the picture
constexpr StripLayout kPair{2, 788, 560};
constexpr int kStillWidth = 1280, kStillHeight = 960;

/// Time of a picture of the simulation [s].
double moment(double end, int k) { return end * k / (kMoments.cells - 1); }

/// Across the way the plan goes, where the trunk was at first.
FloorLine line_at_start(const GaitClip& clip) {
  const auto& first = clip.playback->qpos.front();
  const double x = clip.plan.travel[0], y = clip.plan.travel[1],
               length = std::max(std::hypot(x, y), 1e-9);
  const double reach = 0.22;  // [m] to either side
  FloorLine line;
  for (const double side : {-reach, reach})
    line.points.push_back({first[0] - side * y / length, first[1] + side * x / length, 0.001});
  line.rgba = {0.35F, 0.38F, 0.42F, 1.0F};
  line.radius = 0.0025;
  return line;
}

/// Where the trunk went, on the floor.
FloorLine path_until(const GaitClip& clip, double time) {
  FloorLine line;
  for (std::size_t i = 0; i < clip.playback->time.size() && clip.playback->time[i] <= time + 1e-9;
       i += 4) {
    const auto& qpos = clip.playback->qpos[i];
    line.points.push_back({qpos[0], qpos[1], 0.002});
  }
  line.rgba = {0.10F, 0.50F, 0.34F, 1.0F};
  line.radius = 0.003;
  return line;
}

std::string note_of(const GaitClip& clip, const char* what) {
  if (!clip.fell) return what;
  return fmt::format("{}: falls after {:.2f} s{}", what, *clip.fell,
                     clip.falls_in_playback() ? "" : ", later than shown");
}

/// The last moment shown [s]: the end of the record, but where nobody falls not so late that a
/// fast robot would be small in the picture of its way.
double end_shown(const std::vector<GaitClip>& clips) {
  constexpr double kLongestWay = 1.0;  // [m]
  double end = 0.0;
  bool falls = false;
  for (const GaitClip& clip : clips) {
    end = std::max(end, clip.playback->time.back());
    falls = falls || clip.falls_in_playback();
  }
  const Trajectory& plan = clips.back().plan;
  const double speed = std::hypot(plan.travel[0], plan.travel[1]) / plan.period;
  if (falls || speed * end <= kLongestWay) return end;
  return std::min(end, std::max(2.0 * plan.period, kLongestWay / speed));
}

StripRow physics_row(const GlContext& context, const GaitClip& clip, double end, const View& view) {
  StripRow row;
  row.title = clip.title;
  row.note = note_of(clip, "simulated by MuJoCo");
  row.good = clip.passed;
  Renderer renderer = cell_renderer(context, *clip.model, kMoments);
  const FloorLine start_line = line_at_start(clip);
  for (int k = 0; k < kMoments.cells; ++k) {
    const double time = moment(end, k);
    const FloorLine lines[] = {start_line, path_until(clip, time)};
    Image cell = downsample(
        renderer.render(pose_at(*clip.model, *clip.playback, time), view, lines), kSampling);
    // Once in full colour as the record ends; what comes later has not been simulated.
    if (k > 0 && time > clip.playback->time.back() + 0.02 &&
        moment(end, k - 1) > clip.playback->time.back() - 0.02)
      fade(cell, 0.7);
    row.cells.push_back(std::move(cell));
  }
  return row;
}

}  // namespace

PlannedStrip planned_strip(const GlContext& context, const std::vector<GaitClip>& clips) {
  PlannedStrip strip{{}, {}, kPhases};
  std::vector<Poses> poses, at_home;  // the latter without the way: the camera goes along
  for (const GaitClip& clip : clips) {
    poses.push_back(planned_poses(*clip.model, clip.plan, kPhases.cells, clip.scene));
    at_home.push_back(poses.back());
    for (std::size_t k = 0; k < at_home.back().size(); ++k)
      for (std::size_t axis : {0U, 1U})
        at_home.back()[k][axis] -= clip.plan.travel[axis] * static_cast<double>(k) / kPhases.cells;
  }
  std::vector<PosedModel> robots;
  for (std::size_t i = 0; i < clips.size(); ++i)
    robots.push_back({clips[i].model.get(), &at_home[i]});
  const View view =
      frame_robots(robots, side_view(clips.back().plan), kSideElevation, aspect(kPhases));
  for (std::size_t i = 0; i < clips.size(); ++i) {
    StripRow row;
    row.title = clips[i].title;
    row.note = "planned gait";
    row.contact = contact_marks(clips[i].plan, kPhases.cells);
    Renderer renderer = cell_renderer(context, *clips[i].model, kPhases);
    for (std::size_t k = 0; k < poses[i].size(); ++k) {
      const View along = moved_along(view, clips[i].plan, static_cast<double>(k) / kPhases.cells);
      row.cells.push_back(downsample(renderer.render(poses[i][k], along), kSampling));
    }
    strip.rows.push_back(std::move(row));
  }
  for (int k = 0; k < kPhases.cells; ++k)
    strip.captions.push_back(k == 0 ? "phase 0" : fmt::format("{}/8", k));
  return strip;
}

Image physics_strip(const GlContext& context, const std::vector<GaitClip>& clips) {
  const double end = end_shown(clips);
  std::vector<Poses> poses(clips.size());
  std::vector<PosedModel> robots;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    for (int k = 0; k < kMoments.cells; ++k)
      poses[i].push_back(pose_at(*clips[i].model, *clips[i].playback, moment(end, k)));
    robots.push_back({clips[i].model.get(), &poses[i]});
  }
  const View view =
      frame_robots(robots, side_view(clips.back().plan), kSideElevation, aspect(kMoments), 0.06);
  std::vector<StripRow> rows;
  for (const GaitClip& clip : clips) rows.push_back(physics_row(context, clip, end, view));
  std::vector<std::string> captions;
  for (int k = 0; k < kMoments.cells; ++k)
    captions.push_back(fmt::format("{:.1f} s", moment(end, k)));
  Renderer letters = cell_renderer(context, *clips[0].model, kMoments);
  return compose_strip(kMoments, rows, captions, letters);
}

Image still(const GlContext& context, const GaitClip& clip, double phase) {
  const auto pose = clip.planned_at(phase * clip.plan.period);
  const View view = frame_robot(*clip.model, {pose}, side_view(clip.plan), kSideElevation,
                                static_cast<double>(kStillWidth) / kStillHeight);
  Renderer renderer(context, *clip.model, kStillWidth, kStillHeight, RenderStyle::full);
  return renderer.render(pose, view);
}

Image still_side_by_side(const GlContext& context, const std::vector<GaitClip>& clips,
                         double phase) {
  std::vector<Poses> poses;
  std::vector<PosedModel> robots;
  for (const GaitClip& clip : clips) poses.push_back({clip.planned_at(phase * clip.plan.period)});
  for (std::size_t i = 0; i < clips.size(); ++i)
    robots.push_back({clips[i].model.get(), &poses[i]});
  const View view =
      frame_robots(robots, side_view(clips.back().plan), kSideElevation, aspect(kPair));
  StripRow row;
  row.title = fmt::format("Phase {} of the planned gait", phase);
  std::vector<std::string> captions;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    Renderer renderer(context, *clips[i].model, kPair.cell_width, kPair.cell_height,
                      RenderStyle::full);
    row.cells.push_back(renderer.render(poses[i].front(), view));
    captions.push_back(clips[i].title);
  }
  Renderer letters = cell_renderer(context, *clips[0].model, kPair);
  return compose_strip(kPair, {row}, captions, letters);
}

}  // namespace legwright
