// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/judge_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/listed.hpp"
#include "mjcf/text/robot_files.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/link_folder.hpp"
#include "tools/files/replace_folder.hpp"
#include "tools/files/unfinished_folder.hpp"
#include "tools/run/install.hpp"
#include "tools/run/outer_measured.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/validate/floquet.hpp"
#include "tools/validate/robustness_limits.hpp"
#include "tools/verbs/task_of_run.hpp"
#include "tools/verbs/whole_run.hpp"

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

std::string never_touch_words(const SceneValidation& played) {
  return fmt::format(
      "{} of {} links have no shape that collides with another link's, so nobody asks whether they "
      "pass through each other: {}",
      played.never_touch.size(), played.links, listed(played.never_touch));
}

/// Limits of the file without a row in a verdict.
std::optional<NotJudgedRecord> not_judged_by(const Limits& limits, const Verdict& verdict) {
  std::vector<std::string> names;
  for (const auto& [name, bounds] : limits) {
    const auto is_of = [&, of = name](const JudgedLimit& row) {
      return row.name == of || row.name.starts_with(of + ".");
    };
    if (bounds.by_file && std::none_of(verdict.limits.begin(), verdict.limits.end(), is_of))
      names.push_back(name);
  }
  if (names.empty()) return std::nullopt;
  return NotJudgedRecord{"limits that judge nothing of this task: " + listed(names, names.size()),
                         names};
}

VerdictRecord verdict_record(const JudgedRun& judged, const TaskOfRun& task, const Limits& limits) {
  const Verdict& result = judged.designs[1].verdict;
  VerdictRecord out{.initial = verdict_record(judged.designs[0].verdict),
                    .result = verdict_record(result),
                    .pass = result.pass,
                    .home_touches = {},
                    .not_judged = not_judged_by(limits, result),
                    .run_status = task.early_stop};
  if (const SceneValidation& played = judged.designs[1]; !played.never_touch.empty())
    out.never_touch = {never_touch_words(played), played.never_touch};
  if (!judged.overridden.empty()) {
    out.overridden = {describe_overridden(judged.overridden), {}};
    for (const OverriddenOption& option : judged.overridden)
      out.overridden->options.push_back({option.name, option.file, option.scene});
  }
  if (judged.home_touches.empty()) return out;
  out.home_touches = {describe(judged.home_touches), {}};
  for (const HomeTouch& touch : judged.home_touches)
    out.home_touches->pairs.push_back({touch.first, touch.second, touch.depth});
  return out;
}

/// What the scenes set otherwise than the robot's file; of a run without that file nothing.
/// @param time_step of the scenes [s]
std::vector<OverriddenOption> overridden_in(const ResultFolder& folder, double time_step) {
  const fs::path robot = folder.result() / "robot.xml";
  if (!fs::exists(robot)) return {};
  const RobotFiles files = RobotFiles::read(robot);
  return overridden_options(
      files.at_their_lines([&] { return options_of_mjcf(files.text(), files.file()); }), time_step);
}

/// What of the designed body touches itself in the home pose that did not before. A run without the
/// robots' files, as older programs wrote them, tells nothing.
std::vector<HomeTouch> home_touches_of(const ResultFolder& folder) {
  const fs::path before = folder.iteration(0) / "robot.xml", after = folder.result() / "robot.xml";
  if (!fs::is_regular_file(before) || !fs::is_regular_file(after)) return {};
  return new_home_touches(before, after);
}

void play_and_judge(const ResultFolder& folder, const TaskOfRun& task,
                    const std::vector<fs::path>& others, const JudgeOptions& options,
                    JudgedRun& judged) {
  std::vector<SceneToValidate> scenes{scene_to_validate(folder.iteration(0)),
                                      scene_to_validate(folder.result())};
  for (const fs::path& other : others) scenes.push_back(scene_to_validate(other));
  judged.designs = validate_scenes(scenes, task.wanted, task.gait, options.validation);
  judged.verdict_at_gains = judged.designs[1].verdict;
  judge_further(task, scenes[1], options, judged);
  judged.metrics = metrics_record(task, options.validation, scenes, judged.designs);
  judged.home_touches = home_touches_of(folder);
  judged.overridden = overridden_in(folder, judged.designs[1].timestep);
}

/// What the body was to lower, as measured, goes into run.json beside what the plans have of it.
void tell_outer(const ResultFolder& folder, const MetricsRecord& metrics) {
  auto run = read_record_file<RunRecord>(folder.run_json());
  if (!run.outer) return;
  run.outer->measured = outer_measured(*run.outer, metrics);
  write_json(folder.run_json(), json_of(run));
}

using Texts = std::vector<std::pair<std::string, std::string>>;

/// The other files of a judgement by name, as they will stand.
Texts texts_of(const JudgedRun& judged) {
  const SceneValidation &initial = judged.designs[0], &result = judged.designs[1];
  ComparisonRecord compared = comparison_record(initial.comparison, result.comparison);
  compared.of = judged.of;
  Texts texts{{"playback_initial.csv", playback_csv(initial)},
              {"playback_result.csv", playback_csv(result)},
              {"metrics.json", to_text(json_of(judged.metrics))},
              {"comparison.json", to_text(json_of(compared))}};
  if (const auto record = judged.numerics_record())
    texts.emplace_back("numerics.json", to_text(json_of(*record)));
  if (const auto record = judged.robustness_record())
    texts.emplace_back("robustness.json", to_text(json_of(*record)));
  return texts;
}

/// Pictures of what an earlier judgement played go away with it.
void remove_pictures_of_another(const fs::path& result, const std::string& verdict) {
  const fs::path old = result / "verdict.json";
  if (!fs::is_regular_file(old) || read_file(old) == verdict) return;
  for (const char* name : {"strip_physics.png", "overlay.png", "contact_timeline.png", "gait.webp"})
    fs::remove(result / name);
}

/// Into a folder that has what an earlier judgement wrote, or its copy.
void write_files(const fs::path& where, const Texts& texts, const std::string& verdict) {
  remove_pictures_of_another(where, verdict);
  std::set<std::string> written;
  for (const auto& [name, text] : texts) {
    write_file(where / name, text);
    written.insert(name);
  }
  for (const char* name : {"numerics.json", "robustness.json"})
    if (!written.contains(name)) fs::remove(where / name);
  write_file(where / "verdict.json", verdict);  // last: all it rests on is there
}

/// Whether the process stands in a folder, and with it most likely the shell that it was called in:
/// both would be left in a removed one.
bool works_in(const fs::path& folder) {
  std::error_code error;
  const fs::path relative = fs::current_path(error).lexically_relative(folder);
  return !error && !relative.empty() && *relative.begin() != "..";
}

}  // namespace

std::optional<NumericsRecord> JudgedRun::numerics_record() const {
  if (!numerics) return std::nullopt;
  NumericsRecord record = legwright::numerics_record(*numerics);
  record.of = of;
  return record;
}

std::optional<RobustnessRecord> JudgedRun::robustness_record() const {
  if (!robustness) return std::nullopt;
  RobustnessRecord record = legwright::robustness_record(*robustness);
  record.of = of;
  return record;
}

std::string early_stop_words(const std::string& status) {
  const std::string how = status == "interrupted" ? "was interrupted"
                          : status == "failed"    ? "failed"
                                                  : "has not ended (status " + status + ")";
  return "the search " + how + ": what is judged is the best so far, not its result";
}

JudgedRun play_and_judge(const ResultFolder& folder, const std::vector<fs::path>& others,
                         const JudgeOptions& asked) {
  JudgedRun judged;
  judged.of = sums_of_run(folder.root());
  const TaskOfRun task = task_of_run(folder);
  check_belongs_together(folder.root(), read_record_file<RunRecord>(folder.run_json()));
  JudgeOptions options = asked;
  options.validation.limits = with_step_over(asked.validation.limits, task.step_over);
  try {
    play_and_judge(folder, task, others, options, judged);
  } catch (const std::exception& error) {
    check_unchanged(folder.root(), judged.of,
                    sums_of_run(folder.root()));  // then files that vanished are no fault of theirs
    if (dynamic_cast<const MujocoError*>(&error) || dynamic_cast<const TrajectoryError*>(&error))
      throw InputError(error.what());
    throw;
  }
  judged.of.of(kLimitsSum) = limits_sum(options.validation.limits);
  judged.metrics.of = judged.of;
  judged.verdict = verdict_record(judged, task, options.validation.limits);
  judged.verdict.of = judged.of;
  return judged;
}

void write_judged(const ResultFolder& folder, JudgedRun& judged) {
  const auto texts = texts_of(judged);
  judged.verdict.with.emplace();
  for (const auto& [name, text] : texts) judged.verdict.with->of(name) = sha256_hex(text);
  const std::string verdict = to_text(json_of(judged.verdict));
  check_unchanged(folder.root(), judged.of, sums_of_run(folder.root()));
  tell_outer(folder, judged.metrics);
  // The old judgement stands until the whole new one does: it is made beside, and exchanged. Where
  // that cannot be, file by file: a judgement that was broken off is then told from a whole one.
  const fs::path out = fs::canonical(folder.result());
  if (!works_in(out)) {
    const UnfinishedFolder next(out);
    if (link_folder(out, next.path())) {
      write_files(next.path(), texts, verdict);
      if (exchange_at_once(next.path(), out)) return sync_folder(out.parent_path());
    }
  }
  write_files(out, texts, verdict);
}

JudgedRun judge_run(const ResultFolder& folder, const JudgeOptions& options) {
  JudgedRun judged = play_and_judge(folder, {}, options);
  if (options.write)
    write_judged(folder, judged);
  else
    check_unchanged(folder.root(), judged.of, sums_of_run(folder.root()));
  return judged;
}

}  // namespace legwright
