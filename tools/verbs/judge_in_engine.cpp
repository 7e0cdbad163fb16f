// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/judge_in_engine.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "mjcf/text/input_error.hpp"
#include "tools/run/install.hpp"
#include "tools/run/run_lock.hpp"
#include "tools/run/run_reach.hpp"
#include "tools/run/scene_sums.hpp"
#include "tools/validate/limits_file.hpp"
#include "tools/validate/records.hpp"
#include "tools/verbs/task_of_run.hpp"

namespace legwright {
namespace {

Limits limits_of(const EngineOptions& options, const TaskOfRun& task) {
  Limits limits = options.limits.empty() ? default_limits() : read_limits(options.limits);
  if (need_robustness(limits) || ask_for_numerics(limits))
    throw InputError(options.limits.string(), 0, "",
                     "has limits on survival, margins or numerics, which are not measured here; "
                     "take them out, or have `legwright validate RUN --limits " +
                         options.limits.string() + "` measure them");
  limits.erase("numerics");
  return with_step_over(std::move(limits), task.step_over);
}

Measurements measure_in(const Engine& engine, const Scene& scene, const SceneToValidate& what,
                        const TaskOfRun& task, const EngineOptions& options) {
  RolloutOptions rollout;
  rollout.cycles = options.cycles;
  rollout.stop = options.stop;
  if (engine.start) rollout.step = played_by(scene, engine.start(scene));
  Measurements out = measure(scene, task.wanted, what.plan_velocity, rollout);
  if (engine.start) out.warnings.clear();  // MuJoCo did not play, and has nothing to warn of
  return out;
}

void check(const EngineOptions& options) {
  if (options.cycles < 4) throw std::invalid_argument("cycles: expected at least 4");
  if (options.gain_scales.empty()) throw std::invalid_argument("gains: expected at least one");
  for (const double scale : options.gain_scales)
    if (!(std::isfinite(scale) && scale > 0.0))
      throw std::invalid_argument("gains: expected finite factors above 0");
}

EngineRecord record_of_runs(const Engine& engine, const TaskOfRun& task, const Limits& limits,
                            const SceneValidation& played, int cycles) {
  EngineRecord out{
      .engine = engine.name,
      .version = engine.version,
      .task = describe(task.wanted, task.gait),
      .cycles = cycles,
      .timestep = played.timestep,
      .limits = limit_ranges(limits),
      .versions = record_of<ByName<std::string>>(versions(), "versions"),
      .passes = {},
      .verdict = verdict_record(judge(played.at_gains, task.wanted, task.gait, limits)),
      .result = metrics_by_gain(played)};
  for (const Measurements& run : played.at_gains)
    out.passes.emplace_back(gain_name(run.gain_scale),
                            judge({run}, task.wanted, task.gait, limits).pass);
  return out;
}

}  // namespace

EngineRecord judge_in_engine(const ResultFolder& folder, const Engine& engine,
                             const EngineOptions& options) {
  check(options);
  std::optional<RunLock> lock;
  if (options.write) {
    check_no_links(folder.root());
    lock.emplace(folder.root());
  }
  JudgedSums of = sums_of_result(folder.root());
  const TaskOfRun task = task_of_run(folder);
  check_scene(folder.root(), read_record_file<RunRecord>(folder.run_json()), "result");
  const Limits limits = limits_of(options, task);
  SceneValidation played;
  try {
    const SceneToValidate what = scene_to_validate(folder.result());
    for (const double scale : options.gain_scales) {
      // With all geoms: engines tell of contacts by the numbers that these have in the file.
      const Scene scene = load_scene(what.scene, scale, MeshDetail::triangles);
      played.timestep = scene.model->opt.timestep;
      played.at_gains.push_back(measure_in(engine, scene, what, task, options));
    }
  } catch (const MujocoError& error) {
    throw InputError(error.what());
  } catch (const TrajectoryError& error) {
    throw InputError(error.what());
  }
  EngineRecord record = record_of_runs(engine, task, limits, played, options.cycles);
  of.of(kLimitsSum) = limits_sum(limits);
  check_unchanged(folder.root(), of, sums_of_result(folder.root()));
  record.of = std::move(of);
  if (options.write) write_json(folder.result() / engine_file(engine.name), json_of(record));
  return record;
}

}  // namespace legwright
