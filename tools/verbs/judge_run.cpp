// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/judge_run.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "mjcf/text/input_error.hpp"
#include "optimizer/motion/path.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/install.hpp"
#include "tools/run/motion_csv.hpp"
#include "tools/run/task_folders.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/validate/comparison_json.hpp"
#include "tools/validate/metrics_json.hpp"
#include "tools/validate/robustness_json.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct TaskOfRun {
  std::string gait;
  WantedMotion wanted;
  double step_over = 0.0;  // that every foot shall pass over [m]
};

TaskOfRun read_task(const ResultFolder& folder) {
  const Json run = read_json(folder.run_json());
  try {
    const Json& task = run.at("task");
    const Json& velocity = task.at("velocity");
    return {task.at("gait").get<std::string>(),
            {{velocity.at(0).get<double>(), velocity.at(1).get<double>()},
             task.at("turn_rate").get<double>()},
            task.value("step_over_m", 0.0)};
  } catch (const Json::exception& error) {
    throw InputError(
        folder.run_json().string(), 0, "task",
        std::string("expected gait, velocity and turn_rate as `legwright optimize` writes them; ") +
            error.what());
  }
}

// What the plan itself reached in its cycle, against which the simulation is compared as well: the
// velocity of the COM along its arc. The plan holds what the root did; its COM goes along with it.
Eigen::Vector2d velocity_of(const Trajectory& plan) {
  const auto at_start = [&](int column) { return plan.at(0, column); };
  const Eigen::Vector2d com(at_start(plan.com_column(0)) - at_start(plan.root_column(0)),
                            at_start(plan.com_column(1)) - at_start(plan.root_column(1)));
  const Eigen::Vector2d step =
      Eigen::Vector2d(plan.travel[0], plan.travel[1]) + Eigen::Rotation2Dd(plan.turn) * com - com;
  return WantedPath::velocity_along_arc(step, plan.turn, plan.period);
}

SceneToValidate scene_in(const fs::path& folder) {
  SceneToValidate out{folder / "scene.xml", Eigen::Vector2d::Zero()};
  if (!fs::is_regular_file(out.scene)) {
    throw IoError(out.scene.string() +
                  ": no such file; the run was stopped before it was written: run `legwright " +
                  "optimize` again");
  }
  const Trajectory plan = read_motion_csv(folder / "motion.csv");
  out.plan_velocity = velocity_of(plan);
  return out;
}

Json metrics_json(const TaskOfRun& task, const ValidationOptions& options,
                  const std::vector<SceneToValidate>& scenes,
                  const std::vector<SceneValidation>& results) {
  const auto plan_velocity = [&](std::size_t i) {
    return Json{scenes[i].plan_velocity.x(), scenes[i].plan_velocity.y()};
  };
  return {
      {"schema", "legwright/validation"},
      {"version", 1},
      {"task", describe(task.wanted, task.gait)},
      {"wanted_velocity_mps", {task.wanted.velocity.x(), task.wanted.velocity.y()}},
      {"wanted_turn_rate_radps", task.wanted.turn_rate},
      {"plan_velocity_mps", {{"initial", plan_velocity(0)}, {"result", plan_velocity(1)}}},
      {"cycles", options.cycles},
      {"timestep_s", results[1].timestep},
      {"robot_mass_kg", {{"initial", results[0].robot_mass}, {"result", results[1].robot_mass}}},
      {"limits", limits_json(options.limits)},
      {"versions", versions()},
      {"initial", gains_json(results[0])},
      {"result", gains_json(results[1])}};
}

}  // namespace

namespace {

// Whether the verdict hangs on how MuJoCo computes, as a row of it.
JudgedLimit numerics_limit(const SecondOpinion& opinion, const Bounds& bounds) {
  JudgedLimit out{"numerics", "other numerics with another verdict", "1", bounds, {}, "", true, ""};
  out.value = static_cast<double>(opinion.reasons.size());
  out.pass = within(out.value, bounds);
  for (const std::string& reason : opinion.reasons)
    if (!out.pass) out.reason += (out.reason.empty() ? "the verdict is another " : "; ") + reason;
  return out;
}

/// The result under other numerics and disturbances; the verdict on it again with what they add.
void judge_further(const TaskOfRun& task, const SceneToValidate& scene, const JudgeOptions& options,
                   JudgedRun& judged) {
  const Limits& limits = options.validation.limits;
  SceneValidation& result = judged.designs[1];
  std::vector<JudgedLimit> further;
  if (options.numerics) {
    judged.numerics =
        second_opinion(scene, task.wanted, task.gait, options.validation, at_default_gains(result));
    if (const auto found = limits.find("numerics"); found != limits.end() && found->second.any())
      further.push_back(numerics_limit(*judged.numerics, found->second));
  }
  if (options.robustness) {
    RobustnessOptions disturbed = options.disturbed;
    disturbed.threads = options.validation.threads;
    disturbed.tested = tested_for(limits);
    judged.robustness = measure_robustness(scene.scene, task.wanted, disturbed);
    for (auto& row : judge_robustness(*judged.robustness, limits))
      further.push_back(std::move(row));
  }
  if (!further.empty())
    result.verdict = judge(result.at_gains, task.wanted, task.gait, limits, further);
}

/// Null where there are none.
Json home_touches_json(const std::vector<HomeTouch>& touches) {
  if (touches.empty()) return nullptr;
  Json pairs = Json::array();
  for (const HomeTouch& touch : touches)
    pairs.push_back({{"first", touch.first}, {"second", touch.second}, {"depth_m", touch.depth}});
  return {{"line", describe(touches)}, {"pairs", pairs}};
}

/// What of the designed body touches itself in the home pose that did not before. A run without the robots' files, as
/// older programs wrote them, tells nothing.
std::vector<HomeTouch> home_touches_of(const ResultFolder& folder) {
  const fs::path before = folder.iteration(0) / "robot.xml", after = folder.result() / "robot.xml";
  if (!fs::is_regular_file(before) || !fs::is_regular_file(after)) return {};
  return new_home_touches(before, after);
}

void write_or_remove(const fs::path& file, const std::optional<Json>& document) {
  if (document)
    write_json(file, *document);
  else
    fs::remove(file);  // of an earlier validation, which this one would seem to have made
}

void write_judged(const ResultFolder& folder, const JudgedRun& judged) {
  const SceneValidation &initial = judged.designs[0], &result = judged.designs[1];
  const fs::path out = folder.result();
  write_file(out / "playback_initial.csv", playback_csv(initial));
  write_file(out / "playback_result.csv", playback_csv(result));
  write_json(out / "metrics.json", judged.metrics);
  write_json(out / "comparison.json", comparison_json(initial.comparison, result.comparison));
  const auto& numerics = judged.numerics;
  const auto& robustness = judged.robustness;
  write_or_remove(out / "numerics.json",
                  numerics ? std::optional(numerics_json(*numerics)) : std::nullopt);
  write_or_remove(out / "robustness.json",
                  robustness ? std::optional(robustness_json(*robustness)) : std::nullopt);
  write_json(out / "verdict.json", judged.verdict);  // last: all that it rests on is there
}

}  // namespace

JudgedRun judge_run(const ResultFolder& folder, const std::vector<fs::path>& others,
                    const JudgeOptions& asked) {
  const TaskOfRun task = read_task(folder);
  JudgeOptions options = asked;
  options.validation.limits = with_step_over(asked.validation.limits, task.step_over);
  JudgedRun judged;
  try {
    std::vector<SceneToValidate> scenes{scene_in(folder.iteration(0)), scene_in(folder.result())};
    for (const fs::path& other : others) scenes.push_back(scene_in(other));
    judged.designs = validate_scenes(scenes, task.wanted, task.gait, options.validation);
    judged.metrics = metrics_json(task, options.validation, scenes, judged.designs);
    judge_further(task, scenes[1], options, judged);
    judged.home_touches = home_touches_of(folder);
  } catch (const MujocoError& error) {
    throw InputError(error.what());
  } catch (const TrajectoryError& error) {
    throw InputError(error.what());
  }
  const SceneValidation &initial = judged.designs[0], &result = judged.designs[1];
  judged.verdict = {{"schema", "legwright/verdict"},
                    {"version", 1},
                    {"initial", verdict_json(initial.verdict)},
                    {"result", verdict_json(result.verdict)},
                    {"pass", result.verdict.pass},
                    {"home_touches", home_touches_json(judged.home_touches)}};
  write_judged(folder, judged);
  return judged;
}

namespace {

/// The best body of one task alone, as the joint run from it found it.
struct AloneBody {
  std::string task;
  Json start;  // of run.json's "starts"
};

/// Those whose joint run was reached: a run that was stopped may lack some.
std::vector<AloneBody> bodies_alone(const ResultFolder& folder, const Json& run) {
  std::vector<AloneBody> bodies;
  for (const TaskFolder& task : task_folders(record_of<RunRecord>(run, "run.json")))
    for (const Json& start : run.at("starts"))
      if (start.at("start") == task.name &&
          fs::is_directory(folder.root() / "starts" / ("from-" + task.name)))
        bodies.push_back({task.name, start});
  return bodies;
}

Json judge_bodies(const ResultFolder& folder, const Json& run, const JudgeOptions& options,
                  std::vector<JudgedRun>& judged) {
  // Designs, in the order of the matrix: the initial body, the best body of each task alone where
  // the run has looked for them, the joint result.
  const std::vector<AloneBody> bodies = bodies_alone(folder, run);
  const std::vector<TaskFolder> tasks =
      task_folders(record_of<RunRecord>(run, "run.json"));  // checked: nothing outside the run
  Json designs = Json::array({{{"name", "initial body"}, {"start", "initial"}}});
  for (const AloneBody& body : bodies)
    designs.push_back({{"name", "for " + body.task + " alone"}, {"start", body.task}});
  designs.push_back({{"name", "for all tasks"}, {"start", run.at("best_start")}});
  Json cells = Json::object();
  bool pass = true;
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    const std::string& name = tasks[t].name;
    std::vector<fs::path> others;
    for (const AloneBody& body : bodies)
      others.push_back(folder.root() / "starts" / ("from-" + body.task) / name / "iterations" /
                       "0000");
    const ResultFolder own = ResultFolder::open(folder.root() / tasks[t].relative);
    judged.push_back(judge_run(own, others, options));
    std::vector<const SceneValidation*> order{&judged.back().designs[0]};
    for (std::size_t k = 2; k < judged.back().designs.size(); ++k)
      order.push_back(&judged.back().designs[k]);
    order.push_back(&judged.back().designs[1]);
    cells[name] = Json::array();
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool last = k + 1 == order.size();
      const Json& at_start = k == 0 ? run.at("starts").at(0) : bodies[last ? 0 : k - 1].start;
      const Json F = last ? run.at("tasks").at(t).at("F") : at_start.at("F_tasks_start").at(name);
      cells[name].push_back({{"F", F},
                             {"pass", order[k]->verdict.pass},
                             {"line", order[k]->verdict.line},
                             {"gains", gains_json(*order[k])}});
    }
    pass = pass && judged.back().designs[1].verdict.pass;
  }
  const Json matrix{{"schema", "legwright/matrix"},
                    {"version", 1},
                    {"designs", designs},
                    {"cells", cells},
                    {"pass", pass}};
  write_json(folder.result() / "matrix.json", matrix);
  return matrix;
}

}  // namespace

Json judge_joint_run(const ResultFolder& folder, const Json& run, const JudgeOptions& options,
                     std::vector<JudgedRun>& judged) {
  try {
    return judge_bodies(folder, run, options, judged);
  } catch (const Json::exception& error) {
    throw InputError(
        folder.run_json().string(), 0, "",
        std::string(
            "not the run.json of a joint run that came to its end; run `legwright optimize` "
            "again: ") +
            error.what());
  }
}

}  // namespace legwright
