// SPDX-License-Identifier: Apache-2.0
#include "tools/render/gait_clip.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mjcf/text/input_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/motion_csv.hpp"

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

std::vector<std::pair<double, double>> intervals(const Json& list) {
  std::vector<std::pair<double, double>> found;
  for (const Json& pair : list)
    found.emplace_back(pair.at(0).get<double>(), pair.at(1).get<double>());
  return found;
}

/// An object that `validate` wrote, empty where there is none yet.
Json read_object(const fs::path& file) {
  if (!fs::exists(file)) return Json::object();
  Json values = read_json(file);
  if (!values.is_object())
    throw InputError(file.string(), 0, "",
                     fmt::format("found a JSON {}, expected an object; the file is damaged: run "
                                 "`legwright validate` again",
                                 values.type_name()));
  return values;
}

bool is_true(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

/// What `validate` told of one design; a file of another version may lack any of it.
void read_metrics(const Json& metrics, const char* design, GaitClip& clip) {
  try {
    const Json& values = metrics.at(design).at("default");
    const Json& fall = values.at("fall");
    if (fall.is_object()) clip.fell = fall.at("time_s").get<double>();
    for (const Json& foot : values.at("feet")) {
      clip.feet.push_back({foot.at("name").get<std::string>(),
                           intervals(foot.at("planned_stances_s")),
                           intervals(foot.at("contacts_s"))});
    }
  } catch (const Json::exception&) {
    clip.feet.clear();
  }
}

}  // namespace

std::vector<double> GaitClip::planned_at(double time) const {
  return planned_poses(*model, plan, std::vector<double>{time}, scene).front();
}

std::vector<GaitClip> load_clips(const fs::path& run) {
  const fs::path result = run / "result";
  const bool motion_only = is_true(read_json(run / "run.json"), "motion_only");
  std::vector<GaitClip> clips;
  std::vector<const char*> designs;
  if (!motion_only) {
    clips.push_back(load_clip("Before: the initial body, its gait optimised",
                              run / "iterations" / "0000", result / "playback_initial.csv"));
    designs.push_back("initial");
  }
  clips.push_back(load_clip(
      motion_only ? "The initial body, its gait optimised" : "After: body and gait co-designed",
      result, result / "playback_result.csv"));
  designs.push_back("result");
  const Json verdict = read_object(result / "verdict.json"),
             metrics = read_object(result / "metrics.json");
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const Json verdict_of_design = verdict.value(designs[i], Json::object());
    if (const auto pass = verdict_of_design.find("pass");
        pass != verdict_of_design.end() && pass->is_boolean())
      clips[i].passed = pass->get<bool>();
    read_metrics(metrics, designs[i], clips[i]);
  }
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
