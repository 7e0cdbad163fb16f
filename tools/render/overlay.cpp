// SPDX-License-Identifier: Apache-2.0
// The plan's ghost over what the simulation did.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/render/strips.hpp"

namespace legwright {
namespace {

constexpr StripLayout kOverlay{6, 260, 200};
constexpr Rgb kPlan{28, 92, 220};

/// Which cycle to show: the last whole one, or that in which it fell (not its very start).
int cycle_shown(const GaitClip& clip) {
  const double period = clip.plan.period, end = clip.playback->time.back();
  const double last = clip.falls_in_playback() ? std::floor(end / period - 0.25)
                                               : std::floor(end / period + 1e-6) - 1;
  return static_cast<int>(std::max(0.0, last));
}

/// The clip's cells: times, and poses with the plan's way taken out, so that one camera fits all.
struct Cells {
  std::vector<double> time;
  Poses planned, simulated;
};

Cells cells_of(const GaitClip& clip) {
  Cells cells;
  for (int k = 0; k < kOverlay.cells; ++k) {
    const double share = static_cast<double>(k) / kOverlay.cells;
    cells.time.push_back((cycle_shown(clip) + share) * clip.plan.period);
    cells.planned.push_back(clip.planned_at(cells.time.back()));
    cells.simulated.push_back(pose_at(*clip.model, *clip.playback, cells.time.back()));
    auto &plan = cells.planned.back(), &real = cells.simulated.back();
    for (std::size_t axis : {0U, 1U}) {
      real[axis] -= plan[axis];
      plan[axis] = 0.0;
    }
  }
  return cells;
}

/// Draws the edge of what moves in `seen` into a picture of the same size.
void draw_outline(const mjModel& model, const IdImage& seen, Image& image) {
  const auto moves = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= seen.width || y >= seen.height) return false;
    const int id = seen.id[static_cast<std::size_t>(y) * static_cast<std::size_t>(seen.width) +
                           static_cast<std::size_t>(x)];
    return id > 0 && model.body_weldid[model.geom_bodyid[id - 1]] != 0;
  };
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (moves(x, y)) continue;
      bool near = false;  // a line two pixels wide, around the robot
      for (int dy = -2; dy <= 2 && !near; ++dy)
        for (int dx = -2; dx <= 2 && !near; ++dx)
          near = dx * dx + dy * dy <= 5 && moves(x + dx, y + dy);
      if (near) std::copy(kPlan.begin(), kPlan.end(), image.pixel(x, y));
    }
  }
}

}  // namespace

Image overlay_strip(const GlContext& context, const std::vector<GaitClip>& clips) {
  std::vector<Cells> cells;
  for (const GaitClip& clip : clips) cells.push_back(cells_of(clip));
  std::vector<PosedModel> robots;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    robots.push_back({clips[i].model.get(), &cells[i].planned});
    robots.push_back({clips[i].model.get(), &cells[i].simulated});
  }
  const View view =
      frame_robots(robots, side_view(clips.back().plan), kSideElevation, aspect(kOverlay), 0.08);
  std::vector<StripRow> rows;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    StripRow row;
    row.title = clips[i].title;
    row.good = clips[i].passed;
    row.note =
        fmt::format("simulated by MuJoCo, cycle {}; blue outline: the plan at the same moment",
                    cycle_shown(clips[i]) + 1);
    Renderer renderer = cell_renderer(context, *clips[i].model, kOverlay);
    for (std::size_t k = 0; k < cells[i].time.size(); ++k) {
      const GhostPose ghost{cells[i].planned[k]};
      Image drawn = renderer.render(cells[i].simulated[k], view, {}, &ghost);
      draw_outline(*clips[i].model, renderer.ids(cells[i].planned[k], view), drawn);
      Image cell = downsample(drawn, kSampling);
      if (cells[i].time[k] > clips[i].playback->time.back() + 0.02) fade(cell, 0.6);
      row.cells.push_back(std::move(cell));
    }
    rows.push_back(std::move(row));
  }
  std::vector<std::string> captions;
  for (int k = 0; k < kOverlay.cells; ++k)
    captions.push_back(k == 0 ? "phase 0" : fmt::format("{}/{}", k, kOverlay.cells));
  Renderer letters = cell_renderer(context, *clips[0].model, kOverlay);
  return compose_strip(kOverlay, rows, captions, letters);
}

}  // namespace legwright
