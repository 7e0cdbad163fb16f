// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plugin/trajectory.hpp"
#include "tools/render/film_strip.hpp"
#include "tools/render/poses.hpp"

namespace legwright {

/// When a foot stood: planned within one cycle (an end may lie in the next), and as simulated.
struct FootBars {
  std::string name;
  std::vector<std::pair<double, double>> planned, measured;  // [s]
};

/// One robot of a run with its planned gait, and what the simulation did with it.
struct GaitClip {
  std::string title;
  std::filesystem::path scene;
  ModelPointer model;
  Trajectory plan;
  std::optional<Playback> playback;  // at the gains of the scene
  std::optional<bool> passed;
  std::optional<double> fell;  // [s]
  std::vector<FootBars> feet;  // of the simulation; none where it is not validated

  /// It fell while it was recorded; a playback holds only the first seconds.
  bool falls_in_playback() const {
    return fell && playback && *fell <= playback->time.back() + 0.05;
  }
  /// The plan's pose at a time [s], cycles after the first included.
  std::vector<double> planned_at(double time) const;
};

/// Before and after; of a motion-only run, where the two are one, that one. Nothing simulated where
/// validate judged another result.
/// Throws InputError for a damaged file, std::system_error where one cannot be read.
std::vector<GaitClip> load_clips(const std::filesystem::path& run);

/// The direction of sight from which the plan walks from left to right [deg].
double side_view(const Trajectory& plan);
/// The same for a way along x and y [m].
double side_view(double x, double y);
inline constexpr double kSideElevation = -14.0;  // [deg]

inline double aspect(const StripLayout& layout) {
  return static_cast<double>(layout.cell_width) / layout.cell_height;
}

/// The view moved along by `share` of the way of one cycle (or of several: share above 1).
View moved_along(View view, const Trajectory& plan, double share);

/// Cells are drawn this much larger, then shrunk: smoother than the rasteriser's own antialiasing
/// at a third of its cost.
inline constexpr int kSampling = 2;
Renderer cell_renderer(const GlContext& context, const mjModel& model, const StripLayout& layout);

}  // namespace legwright
