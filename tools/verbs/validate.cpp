// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>

#include "mjcf/input_error.hpp"
#include "optimizer/motion/path.hpp"
#include "tools/io/install.hpp"
#include "tools/io/io_error.hpp"
#include "tools/io/json_file.hpp"
#include "tools/io/result_folder.hpp"
#include "tools/report/tables.hpp"
#include "tools/simulate/metrics_json.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/validation.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

struct Options {
  std::string run;
  ValidationOptions validation;
  bool json = false;
};

struct TaskOfRun {
  std::string gait;
  WantedMotion wanted;
};

TaskOfRun read_task(const ResultFolder& folder) {
  const Json run = read_json(folder.run_json());
  try {
    const Json& task = run.at("task");
    const Json& velocity = task.at("velocity");
    return {task.at("gait").get<std::string>(),
            {{velocity.at(0).get<double>(), velocity.at(1).get<double>()},
             task.at("turn_rate").get<double>()}};
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

SceneToValidate scene_in(const std::filesystem::path& folder) {
  SceneToValidate out{folder / "scene.xml", Eigen::Vector2d::Zero()};
  if (!std::filesystem::is_regular_file(out.scene)) {
    throw IoError(out.scene.string() +
                  ": no such file; the run was stopped before it was written: run `legwright " +
                  "optimize` again");
  }
  const Trajectory plan = read_motion_csv(folder / "motion.csv");
  out.plan_velocity = velocity_of(plan);
  return out;
}

Json metrics_json(const TaskOfRun& task, const Options& options,
                  const std::vector<SceneToValidate>& scenes,
                  const std::vector<SceneValidation>& results) {
  const auto plan_velocity = [&](std::size_t i) {
    return Json{scenes[i].plan_velocity.x(), scenes[i].plan_velocity.y()};
  };
  Json versions_used = versions();
  return {
      {"schema", "legwright/validation"},
      {"version", 1},
      {"task", describe(task.wanted, task.gait)},
      {"wanted_velocity_mps", {task.wanted.velocity.x(), task.wanted.velocity.y()}},
      {"wanted_turn_rate_radps", task.wanted.turn_rate},
      {"plan_velocity_mps", {{"initial", plan_velocity(0)}, {"result", plan_velocity(1)}}},
      {"cycles", options.validation.cycles},
      {"timestep_s", results[1].timestep},
      {"robot_mass_kg", {{"initial", results[0].robot_mass}, {"result", results[1].robot_mass}}},
      {"limits", limits_json(options.validation.limits)},
      {"versions", versions_used},
      {"initial", gains_json(results[0])},
      {"result", gains_json(results[1])}};
}

int validate(const Options& options) {
  const ResultFolder folder = ResultFolder::open(options.run);
  const TaskOfRun task = read_task(folder);
  std::vector<SceneToValidate> scenes;
  std::vector<SceneValidation> results;
  try {
    scenes = {scene_in(folder.iteration(0)), scene_in(folder.result())};
    results = validate_scenes(scenes, task.wanted, task.gait, options.validation);
  } catch (const MujocoError& error) {
    throw InputError(error.what());
  } catch (const TrajectoryError& error) {
    throw InputError(error.what());
  }
  const Json metrics = metrics_json(task, options, scenes, results);
  const Json verdict = {{"schema", "legwright/verdict"},
                        {"version", 1},
                        {"initial", verdict_json(results[0].verdict)},
                        {"result", verdict_json(results[1].verdict)},
                        {"pass", results[1].verdict.pass}};
  write_file(folder.result() / "playback_initial.csv", playback_csv(results[0]));
  write_file(folder.result() / "playback_result.csv", playback_csv(results[1]));
  write_json(folder.result() / "metrics.json", metrics);
  write_json(folder.result() / "verdict.json", verdict);
  if (options.json) {
    fmt::print("{}", to_text({{"verdict", verdict}, {"metrics", metrics}}));
  } else {
    fmt::print("initial design:     {}\nco-designed robot:  {}\n", results[0].verdict.line,
               results[1].verdict.line);
  }
  return results[1].verdict.pass ? kOk : kInfeasible;
}

}  // namespace

void add_validate(CLI::App& program, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb =
      program.add_subcommand("validate", "Play the gaits of a run in MuJoCo and judge them");
  verb->add_option("run", options->run, "Folder that legwright optimize wrote")->required();
  verb->add_option("--cycles", options->validation.cycles, "Cycles of the gait to play")
      ->check(CLI::Range(4, 10000))
      ->capture_default_str();
  verb->add_option("--threads", options->validation.threads,
                   "Roll-outs at the same time; results do not depend on it")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  verb->add_flag("--json", options->json, "One JSON document on stdout: verdict and metrics");
  verb->footer(
      "Plays iterations/0000/scene.xml (the initial design) and result/scene.xml, each at half, "
      "default and double\n"
      "servo gains, headless. Passes when the result never falls, keeps 95 to 105 % of the planned "
      "speed along its\n"
      "heading, tilts by less than 0.1 rad, saturates no servo and MuJoCo has nothing to warn of, "
      "at all gains.\n"
      "Writes metrics.json, verdict.json, playback_initial.csv and playback_result.csv into "
      "result/.\n"
      "Exit code: 0 the result passes, 1 it fails, 2 bad input, 3 a file cannot be read or "
      "written.");
  verb->callback([options, &action] { action = [options] { return validate(*options); }; });
}

}  // namespace legwright
