// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/judge_run.hpp"

#include <fmt/format.h>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/robot_files.hpp"
#include "tools/run/install.hpp"
#include "tools/run/outer_measured.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/validate/floquet.hpp"
#include "tools/validate/robustness_limits.hpp"
#include "tools/verbs/task_of_run.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

MetricsRecord metrics_record(const TaskOfRun& task, const ValidationOptions& options,
                             const std::vector<SceneToValidate>& scenes,
                             const std::vector<SceneValidation>& results) {
  const auto plan_velocity = [&](std::size_t i) {
    return std::array{scenes[i].plan_velocity.x(), scenes[i].plan_velocity.y()};
  };
  return {.task = describe(task.wanted, task.gait),
          .wanted_velocity = task.wanted.velocity,
          .wanted_turn_rate = task.wanted.turn_rate,
          .plan_velocity = {plan_velocity(0), plan_velocity(1)},
          .cycles = options.cycles,
          .timestep = results[1].timestep,
          .robot_mass = {results[0].robot_mass, results[1].robot_mass},
          .limits = limit_ranges(options.limits),
          .versions = record_of<ByName<std::string>>(versions(), "versions"),
          .initial = metrics_by_gain(results[0]),
          .result = metrics_by_gain(results[1])};
}

// Whether the verdict hangs on how MuJoCo computes, as a row of it.
JudgedLimit numerics_limit(const SecondOpinion& opinion, const Bounds& bounds) {
  JudgedLimit out{"numerics", "other numerics with another verdict", "1", bounds, {}, "", true, ""};
  out.value = static_cast<double>(opinion.reasons.size());
  out.pass = within(out.value, bounds);
  for (const std::string& reason : opinion.reasons)
    if (!out.pass) out.reason += (out.reason.empty() ? "the verdict is another " : "; ") + reason;
  return out;
}

/// How the result's gait answers to small disturbances, at each of the gains.
void measure_stability(const SceneToValidate& scene, const JudgeOptions& options,
                       SceneValidation& result) {
  std::vector<Scene> scenes;
  for (const Measurements& run : result.at_gains)
    scenes.push_back(load_scene(scene.scene, run.gain_scale));
  const auto found = floquet_multipliers(
      scenes, {.threads = options.validation.threads, .progress = options.validation.progress});
  for (std::size_t k = 0; k < found.size(); ++k) result.at_gains[k].floquet_multiplier = found[k];
}

/// The result under other numerics and disturbances; the verdict on it again with what they add.
void judge_further(const TaskOfRun& task, const SceneToValidate& scene, const JudgeOptions& options,
                   JudgedRun& judged) {
  const Limits& limits = options.validation.limits;
  SceneValidation& result = judged.designs[1];
  std::vector<JudgedLimit> further;
  if (options.numerics) {
    judged.numerics =
        second_opinion(scene, task.wanted, task.gait, options.validation, result.at_gains);
    if (const auto found = limits.find("numerics"); found != limits.end() && found->second.any())
      further.push_back(numerics_limit(*judged.numerics, found->second));
  }
  if (options.stability) measure_stability(scene, options, result);
  if (options.robustness) {
    RobustnessOptions disturbed = options.disturbed;
    disturbed.threads = options.validation.threads;
    disturbed.tested = tested_for(limits);
    disturbed.progress = options.validation.progress;
    judged.robustness = measure_robustness(scene.scene, task.wanted, disturbed);
    for (auto& row : judge_robustness(*judged.robustness, limits))
      further.push_back(std::move(row));
  }
  if (!further.empty())
    result.verdict = judge(result.at_gains, task.wanted, task.gait, limits, further);
}

VerdictRecord verdict_record(const JudgedRun& judged, const TaskOfRun& task) {
  const Verdict& result = judged.designs[1].verdict;
  VerdictRecord out{verdict_record(judged.designs[0].verdict),
                    verdict_record(result),
                    result.pass,
                    {},
                    task.early_stop};
  if (judged.home_touches.empty()) return out;
  out.home_touches = {describe(judged.home_touches), {}};
  for (const HomeTouch& touch : judged.home_touches)
    out.home_touches->pairs.push_back({touch.first, touch.second, touch.depth});
  return out;
}

/// What the scenes set otherwise than the robot's file; of a run without that file nothing.
std::vector<OverriddenOption> overridden_in(const ResultFolder& folder) {
  const fs::path robot = folder.result() / "robot.xml";
  if (!fs::exists(robot)) return {};
  const RobotFiles files = RobotFiles::read(robot);
  return overridden_options(
      files.at_their_lines([&] { return options_of_mjcf(files.text(), files.file()); }));
}

/// What of the designed body touches itself in the home pose that did not before. A run without the
/// robots' files, as older programs wrote them, tells nothing.
std::vector<HomeTouch> home_touches_of(const ResultFolder& folder) {
  const fs::path before = folder.iteration(0) / "robot.xml", after = folder.result() / "robot.xml";
  if (!fs::is_regular_file(before) || !fs::is_regular_file(after)) return {};
  return new_home_touches(before, after);
}

/// A record; without one no file of an earlier validation stays, which this one would seem to have
/// made.
template <class Record>
void write_or_remove(const fs::path& file, const std::optional<Record>& record) {
  if (record)
    write_json(file, json_of(*record));
  else
    fs::remove(file);
}

/// What the body was to lower, as measured, goes into run.json beside what the plans have of it.
void tell_outer(const ResultFolder& folder, const MetricsRecord& metrics) {
  auto run = read_record_file<RunRecord>(folder.run_json());
  if (!run.outer) return;
  run.outer->measured = outer_measured(*run.outer, metrics);
  write_json(folder.run_json(), json_of(run));
}

void write_judged(const ResultFolder& folder, const JudgedRun& judged) {
  const SceneValidation &initial = judged.designs[0], &result = judged.designs[1];
  const fs::path out = folder.result();
  write_file(out / "playback_initial.csv", playback_csv(initial));
  write_file(out / "playback_result.csv", playback_csv(result));
  write_json(out / "metrics.json", json_of(judged.metrics));
  tell_outer(folder, judged.metrics);
  write_json(out / "comparison.json",
             json_of(comparison_record(initial.comparison, result.comparison)));
  write_or_remove(out / "numerics.json", judged.numerics_record());
  write_or_remove(out / "robustness.json", judged.robustness_record());
  write_json(out / "verdict.json", json_of(judged.verdict));  // last: all it rests on is there
}

}  // namespace

std::optional<NumericsRecord> JudgedRun::numerics_record() const {
  if (!numerics) return std::nullopt;
  return legwright::numerics_record(*numerics);
}

std::optional<RobustnessRecord> JudgedRun::robustness_record() const {
  if (!robustness) return std::nullopt;
  return legwright::robustness_record(*robustness);
}

std::string early_stop_words(const std::string& status) {
  const std::string how = status == "interrupted" ? "was interrupted"
                          : status == "failed"    ? "failed"
                                                  : "has not ended (status " + status + ")";
  return "the search " + how + ": what is judged is the best so far, not its result";
}

JudgedRun judge_run(const ResultFolder& folder, const std::vector<fs::path>& others,
                    const JudgeOptions& asked) {
  const TaskOfRun task = task_of_run(folder);
  JudgeOptions options = asked;
  options.validation.limits = with_step_over(asked.validation.limits, task.step_over);
  JudgedRun judged;
  try {
    std::vector<SceneToValidate> scenes{scene_to_validate(folder.iteration(0)),
                                        scene_to_validate(folder.result())};
    for (const fs::path& other : others) scenes.push_back(scene_to_validate(other));
    judged.designs = validate_scenes(scenes, task.wanted, task.gait, options.validation);
    judge_further(task, scenes[1], options, judged);
    judged.metrics = metrics_record(task, options.validation, scenes, judged.designs);
    judged.home_touches = home_touches_of(folder);
    judged.overridden = overridden_in(folder);
  } catch (const MujocoError& error) {
    throw InputError(error.what());
  } catch (const TrajectoryError& error) {
    throw InputError(error.what());
  }
  judged.verdict = verdict_record(judged, task);
  write_judged(folder, judged);
  return judged;
}

}  // namespace legwright
