// SPDX-License-Identifier: Apache-2.0
#include "tools/render/run_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "tools/io/io_error.hpp"
#include "tools/io/json_file.hpp"
#include "tools/io/result_folder.hpp"
#include "tools/render/film_strip.hpp"
#include "tools/render/iteration_painter.hpp"
#include "tools/render/png.hpp"
#include "tools/render/poses.hpp"
#include "tools/report/tables.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kTurnOfView = 24.0;  // [deg] off the exact side view, for depth
constexpr double kElevation = -14.0;
constexpr StripLayout kPhases{8, 196, 176};  // one cycle of the plan
constexpr StripLayout kMoments{
    5, 314, 190};             // seconds of the simulation: wider, to have the way in the picture
constexpr int kSampling = 2;  // cells are drawn this much larger, then shrunk
constexpr const char* kBefore = "Before: the initial body, its gait optimised";
constexpr const char* kAfter = "After: body and gait co-designed";

/// One robot with its planned gait, and what the simulation did with it.
struct Act {
  const char* title;
  ModelPointer model;
  Trajectory plan;
  Poses planned;
  std::optional<Playback> playback;
  std::optional<bool> passed;

  Act(const char* name, const fs::path& folder, const fs::path& playback_file)
      : title(name),
        model(load_scene(folder / "scene.xml")),
        plan(read_motion_csv(folder / "motion.csv")),
        planned(planned_poses(*model, plan, kPhases.cells, folder / "scene.xml")) {
    if (fs::exists(playback_file)) playback = read_playback(*model, playback_file);
  }
};

double aspect(const StripLayout& layout) {
  return static_cast<double>(layout.cell_width) / layout.cell_height;
}

/// The direction of sight from which the plan walks from left to right [deg].
double side_view(const Trajectory& plan) {
  double x = plan.travel[0], y = plan.travel[1];
  if (std::hypot(x, y) < 1e-4) {  // on the spot: look as if it went sideways
    x = 0.0;
    y = 1.0;
  }
  return std::atan2(x, -y) * 180.0 / std::numbers::pi + kTurnOfView;
}

/// Time of a picture of the simulation [s].
double moment(double end, int k) { return end * k / (kMoments.cells - 1); }

class RunDrawing {
 public:
  RunDrawing(const fs::path& run, const RunPictureOptions& options)
      : run_(run), options_(options), painter_(run / "iterations" / "0000" / "scene.xml") {}

  RunPictures draw() {
    draw_stills();
    const fs::path result = run_ / "result";
    if (!fs::exists(result / "scene.xml") || !fs::exists(result / "motion.csv")) {
      out_.left_out.push_back("film strips: the run has no result yet; finish legwright optimize");
      return std::move(out_);
    }
    std::vector<Act> acts;
    acts.emplace_back(kBefore, run_ / "iterations" / "0000", result / "playback_initial.csv");
    acts.emplace_back(kAfter, result, result / "playback_result.csv");
    read_verdict(acts);
    draw_planned(acts);
    if (acts[0].playback && acts[1].playback) {
      draw_physics(acts);
    } else {
      out_.left_out.push_back("strip_physics.png: run legwright validate first");
    }
    return std::move(out_);
  }

 private:
  void write(const fs::path& file, const Image& image, Clock::time_point start) {
    write_png(file, image);
    const std::chrono::duration<double, std::milli> spent = Clock::now() - start;
    out_.made.push_back({file, spent.count()});
    if (options_.on_picture) options_.on_picture(out_.made.back());
  }

  void draw_stills() {
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(run_ / "iterations")) {
      const bool hidden = entry.path().filename().string().starts_with('.');  // half-written
      if (!hidden && fs::exists(entry.path() / "scene.xml")) folders.push_back(entry.path());
    }
    std::sort(folders.begin(), folders.end());
    for (const fs::path& folder : folders) {
      const fs::path file = folder / "frame.png";
      if (!options_.all && fs::exists(file)) continue;
      const auto start = Clock::now();
      painter_.paint(folder / "scene.xml", file);
      const std::chrono::duration<double, std::milli> spent = Clock::now() - start;
      out_.made.push_back({file, spent.count()});
      if (options_.on_picture) options_.on_picture(out_.made.back());
    }
  }

  void read_verdict(std::vector<Act>& acts) const {
    const fs::path file = run_ / "result" / "verdict.json";
    if (!fs::exists(file)) return;
    const Json verdict = read_json(file);
    const char* keys[] = {"initial", "result"};
    for (std::size_t i = 0; i < acts.size(); ++i) {
      const auto found = verdict.find(keys[i]);
      if (found == verdict.end() || !found->is_object()) continue;
      const auto pass = found->find("pass");
      if (pass != found->end() && pass->is_boolean()) acts[i].passed = pass->get<bool>();
    }
  }

  void draw_planned(const std::vector<Act>& acts) {
    auto start = Clock::now();
    std::vector<PosedModel> robots;
    for (const Act& act : acts) robots.push_back({act.model.get(), &act.planned});
    const View view = frame_robots(robots, side_view(acts[1].plan), kElevation, aspect(kPhases));
    std::vector<StripRow> rows;
    for (const Act& act : acts) {
      StripRow row;
      row.title = act.title;
      row.note = "planned gait";
      row.contact = contact_marks(act.plan, kPhases.cells);
      Renderer renderer = cell_renderer(act, kPhases);
      for (const auto& qpos : act.planned)
        row.cells.push_back(shrink(renderer.render(qpos, view), kSampling));
      rows.push_back(std::move(row));
    }
    std::vector<std::string> captions;
    for (int k = 0; k < kPhases.cells; ++k)
      captions.push_back(k == 0 ? "phase 0" : fmt::format("{}/8", k));
    Renderer letters = cell_renderer(acts[0], kPhases);
    const fs::path result = run_ / "result";
    write(result / "strip_initial.png", compose_strip(kPhases, {rows[0]}, captions, letters),
          start);
    start = Clock::now();
    write(result / "strip_result.png", compose_strip(kPhases, {rows[1]}, captions, letters), start);
    start = Clock::now();
    write(result / "strip_before_after.png", compose_strip(kPhases, rows, captions, letters),
          start);
  }

  void draw_physics(const std::vector<Act>& acts) {
    const auto start = Clock::now();
    double end = 0.0;
    for (const Act& act : acts) end = std::max(end, act.playback->time.back());
    std::vector<Poses> chosen(acts.size());
    std::vector<PosedModel> robots;
    for (std::size_t i = 0; i < acts.size(); ++i) {
      for (int k = 0; k < kMoments.cells; ++k) {
        const auto& playback = *acts[i].playback;
        chosen[i].push_back(playback.qpos[record_at(playback, moment(end, k))]);
      }
    }
    for (std::size_t i = 0; i < acts.size(); ++i)
      robots.push_back({acts[i].model.get(), &chosen[i]});
    const View view =
        frame_robots(robots, side_view(acts[1].plan), kElevation, aspect(kMoments), 0.06);
    std::vector<StripRow> rows;
    for (std::size_t i = 0; i < acts.size(); ++i)
      rows.push_back(physics_row(acts[i], chosen[i], end, view));
    std::vector<std::string> captions;
    for (int k = 0; k < kMoments.cells; ++k)
      captions.push_back(fmt::format("{:.1f} s", moment(end, k)));
    Renderer letters = cell_renderer(acts[0], kMoments);
    write(run_ / "result" / "strip_physics.png", compose_strip(kMoments, rows, captions, letters),
          start);
  }

  StripRow physics_row(const Act& act, const Poses& poses, double end, const View& view) {
    StripRow row;
    row.title = act.title;
    row.note = "simulated by MuJoCo";
    row.good = act.passed;
    Renderer renderer = cell_renderer(act, kMoments);
    const FloorLine start_line = line_at_start(act);
    for (int k = 0; k < kMoments.cells; ++k) {
      const FloorLine lines[] = {start_line, path_until(act, moment(end, k))};
      row.cells.push_back(
          shrink(renderer.render(poses[static_cast<std::size_t>(k)], view, lines), kSampling));
    }
    return row;
  }

  /// Across the way the plan goes, where the trunk was at first.
  static FloorLine line_at_start(const Act& act) {
    const auto& first = act.playback->qpos.front();
    const double x = act.plan.travel[0], y = act.plan.travel[1],
                 length = std::max(std::hypot(x, y), 1e-9);
    const double reach = 0.22;  // [m] to either side
    FloorLine line;
    for (const double side : {-reach, reach}) {
      line.points.push_back({first[0] - side * y / length, first[1] + side * x / length, 0.001});
    }
    line.rgba = {0.35F, 0.38F, 0.42F, 1.0F};
    line.radius = 0.0025;
    return line;
  }

  /// Where the trunk went, on the floor.
  static FloorLine path_until(const Act& act, double time) {
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

  Renderer cell_renderer(const Act& act, const StripLayout& layout) const {
    return Renderer(painter_.context(), *act.model, layout.cell_width * kSampling,
                    layout.cell_height * kSampling, RenderStyle::full);
  }

  fs::path run_;
  RunPictureOptions options_;
  IterationPainter painter_;
  RunPictures out_;
};

}  // namespace

RunPictures draw_run(const fs::path& run, const RunPictureOptions& options) {
  const fs::path first = ResultFolder::open(run).iteration(0) / "scene.xml";
  if (!fs::exists(first)) {
    throw IoError(first.string() + ": no such file; the run was stopped before its first design: " +
                  "run `legwright optimize` again");
  }
  return RunDrawing(run, options).draw();
}

}  // namespace legwright
