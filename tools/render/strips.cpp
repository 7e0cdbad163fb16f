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
FloorLine line_at_start(const GaitClip& act) {
  const auto& first = act.playback->qpos.front();
  const double x = act.plan.travel[0], y = act.plan.travel[1],
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
FloorLine path_until(const GaitClip& act, double time) {
  FloorLine line;
  for (std::size_t i = 0; i < act.playback->time.size() && act.playback->time[i] <= time + 1e-9;
       i += 4) {
    const auto& qpos = act.playback->qpos[i];
    line.points.push_back({qpos[0], qpos[1], 0.002});
  }
  line.rgba = {0.10F, 0.50F, 0.34F, 1.0F};
  line.radius = 0.003;
  return line;
}

std::string note_of(const GaitClip& act, const char* what) {
  if (!act.fell) return what;
  return fmt::format("{}: falls after {:.2f} s{}", what, *act.fell,
                     act.falls_in_playback() ? "" : ", later than shown");
}

/// The last moment shown [s]: the end of the record, but where nobody falls not so late that a
/// fast robot would be small in the picture of its way.
double end_shown(const std::vector<GaitClip>& acts) {
  constexpr double kLongestWay = 1.0;  // [m]
  double end = 0.0;
  bool falls = false;
  for (const GaitClip& act : acts) {
    end = std::max(end, act.playback->time.back());
    falls = falls || act.falls_in_playback();
  }
  const Trajectory& plan = acts.back().plan;
  const double speed = std::hypot(plan.travel[0], plan.travel[1]) / plan.period;
  if (falls || speed * end <= kLongestWay) return end;
  return std::min(end, std::max(2.0 * plan.period, kLongestWay / speed));
}

StripRow physics_row(const GlContext& context, const GaitClip& act, double end, const View& view) {
  StripRow row;
  row.title = act.title;
  row.note = note_of(act, "simulated by MuJoCo");
  row.good = act.passed;
  Renderer renderer = cell_renderer(context, *act.model, kMoments);
  const FloorLine start_line = line_at_start(act);
  for (int k = 0; k < kMoments.cells; ++k) {
    const double time = moment(end, k);
    const FloorLine lines[] = {start_line, path_until(act, time)};
    Image cell =
        shrink(renderer.render(pose_at(*act.model, *act.playback, time), view, lines), kSampling);
    // Once in full colour as the record ends; what comes later has not been simulated.
    if (k > 0 && time > act.playback->time.back() + 0.02 &&
        moment(end, k - 1) > act.playback->time.back() - 0.02)
      fade(cell, 0.7);
    row.cells.push_back(std::move(cell));
  }
  return row;
}

}  // namespace

PlannedStrip planned_strip(const GlContext& context, const std::vector<GaitClip>& acts) {
  PlannedStrip strip{{}, {}, kPhases};
  std::vector<Poses> poses, at_home;  // the latter without the way: the camera goes along
  for (const GaitClip& act : acts) {
    poses.push_back(planned_poses(*act.model, act.plan, kPhases.cells, act.scene));
    at_home.push_back(poses.back());
    for (std::size_t k = 0; k < at_home.back().size(); ++k)
      for (std::size_t axis : {0U, 1U})
        at_home.back()[k][axis] -= act.plan.travel[axis] * static_cast<double>(k) / kPhases.cells;
  }
  std::vector<PosedModel> robots;
  for (std::size_t i = 0; i < acts.size(); ++i)
    robots.push_back({acts[i].model.get(), &at_home[i]});
  const View view =
      frame_robots(robots, side_view(acts.back().plan), kSideElevation, aspect(kPhases));
  for (std::size_t i = 0; i < acts.size(); ++i) {
    StripRow row;
    row.title = acts[i].title;
    row.note = "planned gait";
    row.contact = contact_marks(acts[i].plan, kPhases.cells);
    Renderer renderer = cell_renderer(context, *acts[i].model, kPhases);
    for (std::size_t k = 0; k < poses[i].size(); ++k) {
      const View along = moved_along(view, acts[i].plan, static_cast<double>(k) / kPhases.cells);
      row.cells.push_back(shrink(renderer.render(poses[i][k], along), kSampling));
    }
    strip.rows.push_back(std::move(row));
  }
  for (int k = 0; k < kPhases.cells; ++k)
    strip.captions.push_back(k == 0 ? "phase 0" : fmt::format("{}/8", k));
  return strip;
}

Image physics_strip(const GlContext& context, const std::vector<GaitClip>& acts) {
  const double end = end_shown(acts);
  std::vector<Poses> poses(acts.size());
  std::vector<PosedModel> robots;
  for (std::size_t i = 0; i < acts.size(); ++i) {
    for (int k = 0; k < kMoments.cells; ++k)
      poses[i].push_back(pose_at(*acts[i].model, *acts[i].playback, moment(end, k)));
    robots.push_back({acts[i].model.get(), &poses[i]});
  }
  const View view =
      frame_robots(robots, side_view(acts.back().plan), kSideElevation, aspect(kMoments), 0.06);
  std::vector<StripRow> rows;
  for (const GaitClip& act : acts) rows.push_back(physics_row(context, act, end, view));
  std::vector<std::string> captions;
  for (int k = 0; k < kMoments.cells; ++k)
    captions.push_back(fmt::format("{:.1f} s", moment(end, k)));
  Renderer letters = cell_renderer(context, *acts[0].model, kMoments);
  return compose_strip(kMoments, rows, captions, letters);
}

Image still(const GlContext& context, const GaitClip& act, double phase) {
  const auto pose = act.planned_at(phase * act.plan.period);
  const View view = frame_robot(*act.model, {pose}, side_view(act.plan), kSideElevation,
                                static_cast<double>(kStillWidth) / kStillHeight);
  Renderer renderer(context, *act.model, kStillWidth, kStillHeight, RenderStyle::full);
  return renderer.render(pose, view);
}

Image still_side_by_side(const GlContext& context, const std::vector<GaitClip>& acts,
                         double phase) {
  std::vector<Poses> poses;
  std::vector<PosedModel> robots;
  for (const GaitClip& act : acts) poses.push_back({act.planned_at(phase * act.plan.period)});
  for (std::size_t i = 0; i < acts.size(); ++i) robots.push_back({acts[i].model.get(), &poses[i]});
  const View view =
      frame_robots(robots, side_view(acts.back().plan), kSideElevation, aspect(kPair));
  StripRow row;
  row.title = fmt::format("Phase {} of the planned gait", phase);
  std::vector<std::string> captions;
  for (std::size_t i = 0; i < acts.size(); ++i) {
    Renderer renderer(context, *acts[i].model, kPair.cell_width, kPair.cell_height,
                      RenderStyle::full);
    row.cells.push_back(renderer.render(poses[i].front(), view));
    captions.push_back(acts[i].title);
  }
  Renderer letters = cell_renderer(context, *acts[0].model, kPair);
  return compose_strip(kPair, {row}, captions, letters);
}

}  // namespace legwright
