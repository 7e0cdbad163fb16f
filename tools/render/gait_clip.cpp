// SPDX-License-Identifier: Apache-2.0
#include "tools/render/gait_clip.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>

#include "mjcf/text/input_error.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/metrics_record.hpp"
#include "tools/run/motion_csv.hpp"
#include "tools/run/run_record.hpp"
#include "tools/run/verdict_record.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr double kTurnOfView = 24.0;  // [deg] off the exact side view, for depth

GaitClip load_clip(const char* title, const fs::path& folder, const fs::path& playback) {
  GaitClip clip;
  clip.title = title;
  clip.scene = folder / "scene.xml";
  clip.model = load_drawn_scene(clip.scene);
  clip.plan = read_motion_csv(folder / "motion.csv");
  if (fs::exists(playback)) clip.playback = read_playback(*clip.model, playback);
  return clip;
}

/// What `read` makes of a file that a verb wrote. Throws InputError where it is damaged.
template <class Read>
auto read_of(const char* verb, const Read& read) {
  try {
    return read();
  } catch (const IoError& error) {
    throw InputError(fmt::format("{} (run `legwright {}` again)", error.what(), verb));
  }
}

/// What `validate` measured of a design at the gains of the scene.
void add_metrics(const ByName<GainMetrics>& gains, GaitClip& clip) {
  const GainMetrics* measured = gains.find("default");
  if (measured == nullptr) return;
  if (measured->fall) clip.fell = measured->fall->time;
  for (const FootMetrics& foot : measured->feet)
    clip.feet.push_back({foot.name, foot.planned, foot.contacts});
}

constexpr const char* kPlaybacks[] = {"playback_initial.csv", "playback_result.csv"};

/// What `validate` left of the result that stands in a run: nothing that is of another one, or of
/// another judgement than the verdict.
struct JudgedClips {
  std::optional<VerdictRecord> verdict;
  std::optional<MetricsRecord> metrics;
  std::set<std::string> playbacks;
};

JudgedClips judged_of(const fs::path& run) {
  const fs::path result = run / "result";
  JudgedClips out;
  out.verdict = read_of("validate", [&] {
    const fs::path file = result / "verdict.json";
    return fs::exists(file) ? std::optional(read_record_file<VerdictRecord>(file)) : std::nullopt;
  });
  out.metrics = read_of("validate", [&] { return read_metrics(result / "metrics.json"); });
  const JudgedSums here = sums_of_run(run);
  const auto of_another = [&](const auto& record) {
    return record && standing_of(record->of, here) == Standing::of_another;
  };
  if (of_another(out.verdict) || of_another(out.metrics)) return {};
  const auto belongs = [&](const std::string& name) {
    return !out.verdict || !out.verdict->with ||
           names_bytes(*out.verdict->with, name, result / name);
  };
  for (const char* name : kPlaybacks)
    if (belongs(name)) out.playbacks.insert(name);
  if (out.metrics && !belongs("metrics.json")) out.metrics.reset();
  return out;
}

}  // namespace

std::vector<double> GaitClip::planned_at(double time) const {
  return planned_poses(*model, plan, std::vector<double>{time}, scene).front();
}

std::vector<GaitClip> load_clips(const fs::path& run) {
  const fs::path result = run / "result";
  const JudgedClips judged = judged_of(run);
  const auto playback = [&](const char* name) {
    return judged.playbacks.contains(name) ? result / name : fs::path();
  };
  const bool motion_only = read_of(
      "optimize", [&] { return read_record_file<RunRecord>(run / "run.json").motion_only; });
  std::vector<GaitClip> clips;
  if (!motion_only) {
    clips.push_back(load_clip("Before: the initial body, its gait optimised",
                              run / "iterations" / "0000", playback(kPlaybacks[0])));
    if (judged.verdict) clips.back().passed = judged.verdict->initial.pass;
    if (judged.metrics) add_metrics(judged.metrics->initial, clips.back());
  }
  clips.push_back(load_clip(
      motion_only ? "The initial body, its gait optimised" : "After: body and gait co-designed",
      result, playback(kPlaybacks[1])));
  if (judged.verdict) clips.back().passed = judged.verdict->result.pass;
  if (judged.metrics) add_metrics(judged.metrics->result, clips.back());
  return clips;
}

double side_view(const Trajectory& plan) { return side_view(plan.travel[0], plan.travel[1]); }

double side_view(double x, double y) {
  if (std::hypot(x, y) < 1e-4) {  // on the spot: look as if it went sideways
    x = 0.0;
    y = 1.0;
  }
  return std::atan2(x, -y) * 180.0 / std::numbers::pi + kTurnOfView;
}

View moved_along(View view, const Trajectory& plan, double share) {
  for (std::size_t axis : {0U, 1U}) view.lookat[axis] += share * plan.travel[axis];
  return view;
}

Renderer cell_renderer(const GlContext& context, const mjModel& model, const StripLayout& layout) {
  return Renderer(context, model, layout.cell_width * kSampling, layout.cell_height * kSampling,
                  RenderStyle::cheap);
}

}  // namespace legwright
