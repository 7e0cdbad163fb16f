// SPDX-License-Identifier: Apache-2.0
#include "tools/run/run_json.hpp"
#include "tools/run/design_json.hpp"

#include "mjcf/text/safe_path.hpp"
#include "optimizer/design/inertia.hpp"
#include "optimizer/solve/hessian_factor.hpp"
#include "tools/files/checksum.hpp"
#include "tools/run/install.hpp"

namespace legwright {
namespace {

Json numbers_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// What only some tasks have is there only then.
Json task_json(const Task& task) {
  Json json{{"name", task.name},
            {"gait", task.gait.name()},
            {"period_s", task.gait.period()},
            {"knots", task.gait.knot_count()},
            {"planted_margin_knots", task.planted_margin},
            {"velocity", {task.velocity.x(), task.velocity.y()}},
            {"turn_rate", task.turn_rate},
            {"floor_friction", task.floor_friction}};
  if (const SlopeAngles slope = slope_of(task.velocity, task.up);
      slope.along != 0.0 || slope.across != 0.0)
    json["slope_rad"] = {{"along", slope.along}, {"across", slope.across}};
  if (task.payload)
    json["payload"] = {{"mass_kg", task.payload->mass},
                       {"position_m", numbers_of(task.payload->position)},
                       {"size_m", numbers_of(task.payload->size)}};
  if (task.torque_limit) json["torque_limit_Nm"] = *task.torque_limit;
  if (task.servo_kp) json["servo_kp_Nm_per_rad"] = *task.servo_kp;
  if (task.step_over > 0.0) json["step_over_m"] = task.step_over;
  return json;
}

/// What a body weighs and how much of it is printed: of the robot alone, without a payload.
Json body_json(const RobotModel& robot, const Eigen::VectorXd& s) {
  Json body{{"mass_kg", GeometryAtDesign(robot.morphology, s).total_mass}};
  double volume = 0.0;
  for (const Link& link : robot.morphology.links)
    for (const PointMass& point : link.masses) volume += point.volume * point.growth_at(s);
  if (volume > 0.0) body["printed_volume_m3"] = volume;
  return body;
}

Json parameters_json(const DesignSpace& space) {
  Json parameters = Json::array();
  for (const DesignParameter& p : space.parameters)
    parameters.push_back({{"name", p.name},
                          {"unit", p.unit},
                          {"kind", to_string(p.kind)},
                          {"sentence", p.sentence},
                          {"initial", p.initial},
                          {"lower", p.lower},
                          {"upper", p.upper},
                          {"final", p.initial},
                          {"tied_count", p.tied_count}});
  return parameters;
}

Json provenance(const std::vector<std::string>& argv, const CodesignProblem& problem) {
  const RobotFiles& files = problem.robot.files;
  Json sums{{"task.toml", sha256_hex(problem.set.text)},
            {"robot.xml", sha256_hex(files.main_text())}};
  for (const IncludedFile& included : files.includes())
    sums[included.path.generic_string()] = sha256_hex(included.text);
  for (const AssetFile& asset : files.assets())
    sums[asset.path.generic_string()] = sha256_hex(read_regular_file(asset.source, asset.bytes));
  return {{"argv", argv},
          {"versions", versions()},
          {"factorisation", factor_name()},
          {"files",
           {{"task.toml", problem.set.file.string()}, {"robot.xml", problem.robot.file.string()}}},
          {"sha256", sums}};
}

Json head(const CodesignProblem& problem) {
  Json run{{"schema", "legwright/run"},
           {"version", 1},
           {"status", "running"},
           {"robot", problem.robot.morphology.name}};
  if (!problem.set.outer.empty())
    run["outer"] = {{"objective", problem.set.outer}, {"weight", problem.set.outer_weight}};
  return run;
}

void add_effort(Json& run, const RunEffort& effort) {
  run["design_iterations"] = effort.design_iterations;
  run["newton_iterations"] = effort.newton_iterations;
  run["factorisations"] = effort.factorisations;
  run["seconds"] = {{"total", effort.seconds.total},
                    {"motion", effort.seconds.motion},
                    {"adjoint", effort.seconds.adjoint},
                    {"predictor", effort.seconds.predictor},
                    {"files", effort.file_seconds}};
  run["peak_rss_mib"] = peak_memory_mib();
}

void add_final_design(Json& run, const RobotModel& robot, const Eigen::VectorXd& s) {
  for (int k = 0; k < robot.space.size(); ++k) run["parameters"][k]["final"] = s[k];
  run["body"] = {{"initial", body_json(robot, robot.space.initial())},
                 {"final", body_json(robot, s)}};
}

Json task_values(const CodesignProblem& problem, const RunLabel& label,
                 const DesignIteration& iteration) {
  Json values = Json::object();
  for (std::size_t k = 0; k < iteration.tasks.size(); ++k)
    values[problem.task(label.tasks[k]).name] = iteration.tasks[k].value;
  return values;
}

Json start_json(const CodesignProblem& problem, const StartedRun& run) {
  Json tasks = Json::array();
  for (int k : run.label.tasks) tasks.push_back(problem.task(k).name);
  return {{"start", run.label.start},
          {"tasks", tasks},
          {"status", to_string(run.result.status)},
          {"F_start", run.result.initial.value},
          {"F", run.result.best.value},
          {"F_tasks_start", task_values(problem, run.label, run.result.initial)},
          {"F_tasks", task_values(problem, run.label, run.result.best)},
          {"design_iterations", run.result.design_iterations},
          {"newton_iterations", run.result.newton_iterations},
          {"seconds", run.result.seconds.total},
          {"s", by_name(problem.robot.space, run.result.best.s)}};
}

}  // namespace

RunEffort effort_of(const CodesignResult& result) {
  return {result.design_iterations, result.newton_iterations, result.factorisations, result.seconds,
          0.0};
}

RunEffort effort_of(const MultistartResult& result) {
  RunEffort sum;
  for (const std::vector<StartedRun>* runs : {&result.alone, &result.joint})
    for (const StartedRun& run : *runs) {
      const RunEffort one = effort_of(run.result);
      sum.design_iterations += one.design_iterations;
      sum.newton_iterations += one.newton_iterations;
      sum.factorisations += one.factorisations;
      sum.seconds.total += one.seconds.total;
      sum.seconds.motion += one.seconds.motion;
      sum.seconds.adjoint += one.seconds.adjoint;
      sum.seconds.predictor += one.seconds.predictor;
    }
  return sum;
}

Json start_of_run(const std::vector<std::string>& argv, const CodesignProblem& problem, int task) {
  Json run = head(problem);
  run["task"] = task_json(problem.objectives[task]->task());
  run["design_size"] = problem.robot.space.size();
  run["motion_size"] = problem.objectives[task]->layout().motion_size();
  run["parameters"] = parameters_json(problem.robot.space);
  run.update(provenance(argv, problem));
  return run;
}

Json start_of_joint_run(const std::vector<std::string>& argv, const CodesignProblem& problem) {
  Json run = head(problem);
  run["name"] = problem.set.name;
  run["tasks"] = Json::array();
  int motion_size = 0;
  for (int k = 0; k < problem.task_count(); ++k) {
    Json task = task_json(problem.objectives[k]->task());
    task["weight"] = problem.task(k).weight;
    task["folder"] = "tasks/" + problem.task(k).name;
    task["motion_size"] = problem.objectives[k]->layout().motion_size();
    motion_size += problem.objectives[k]->layout().motion_size();
    run["tasks"].push_back(task);
  }
  run["design_size"] = problem.robot.space.size();
  run["motion_size"] = motion_size;
  run["parameters"] = parameters_json(problem.robot.space);
  run.update(provenance(argv, problem));
  return run;
}

void finish_run(Json& run, const std::string& status, const TaskOutcome& outcome,
                const RunEffort& effort, const RobotModel& robot) {
  const TaskIterate& best = outcome.best->tasks.at(outcome.task);
  const PlanQuality& quality = outcome.quality;
  run["status"] = status;
  run["feasible"] = outcome.reasons.empty();
  run["reasons"] = outcome.reasons;
  run["motion_only_F"] = outcome.initial->tasks.at(outcome.task).value;
  run["motion_only_trace"] = outcome.motion_only_trace;
  run["final_F"] = best.value;
  run["final_J"] = best.outer_value;
  run["history"] = outcome.history;
  add_effort(run, effort);
  run["projected_gradient_norm"] = outcome.best->projected_gradient_norm;
  run["motion_status"] = to_string(best.motion_status);
  run["speed_wanted"] = quality.speed_wanted;
  run["speed_reached"] = quality.speed_reached;
  run["heading_error_rad"] = quality.heading_error;
  run["ground_error_m"] = quality.ground_error;
  run["slide_share"] = quality.slide_share;
  run["root_residual"] = quality.root_residual;
  add_final_design(run, robot, outcome.best->s);
}

void add_starts(Json& run, const MultistartResult& result, const CodesignProblem& problem) {
  run["best_start"] = result.joint[result.best].label.start;
  run["starts"] = Json::array();
  for (const StartedRun& one : result.joint) run["starts"].push_back(start_json(problem, one));
}

void finish_joint_run(Json& run, const std::string& status, const MultistartResult& result,
                      const std::vector<TaskOutcome>& outcomes, const RunEffort& effort,
                      const CodesignProblem& problem) {
  const StartedRun& winner = result.joint[result.best];
  run["status"] = status;
  Json reasons = Json::array();
  for (const TaskOutcome& outcome : outcomes)
    for (const std::string& reason : outcome.reasons)
      reasons.push_back(problem.task(outcome.task).name + ": " + reason);
  run["feasible"] = reasons.empty();
  run["reasons"] = reasons;
  for (const TaskOutcome& outcome : outcomes) {
    Json& task = run["tasks"][outcome.task];
    task["F_initial"] = outcome.initial->tasks.at(outcome.task).value;
    task["F"] = outcome.best->tasks.at(outcome.task).value;
    task["speed_wanted"] = outcome.quality.speed_wanted;
    task["speed_reached"] = outcome.quality.speed_reached;
    task["feasible"] = outcome.reasons.empty();
  }
  run["motion_only_F"] = result.joint.front().result.initial.value;
  run["final_F"] = winner.result.best.value;
  add_starts(run, result, problem);
  run["alone"] = Json::array();
  for (const StartedRun& one : result.alone) run["alone"].push_back(start_json(problem, one));
  add_effort(run, effort);
  run["projected_gradient_norm"] = winner.result.best.projected_gradient_norm;
  add_final_design(run, problem.robot, winner.result.best.s);
}

Json iteration_event(const DesignSpace& space, const DesignIteration& iteration, int task,
                     const PlanQuality& quality) {
  const TaskIterate& own = iteration.tasks.at(task);
  Json terms = Json::object();
  for (const TermValue& term : own.terms) terms[std::string(term.name)] = term.value;
  return {{"event", "iteration"},
          {"index", iteration.index},
          {"F", own.value},
          {"J", own.outer_value},
          {"terms", terms},
          {"s", by_name(space, iteration.s)},
          {"design_gradient_norm", iteration.projected_gradient_norm},
          {"newton_iterations", own.newton_iterations},
          {"motion_status", to_string(own.motion_status)},
          {"speed_reached", quality.speed_reached},
          {"design_step", iteration.design_step},
          {"seconds", iteration.seconds}};
}

Json joint_iteration_event(const CodesignProblem& problem, const RunLabel& label,
                           const DesignIteration& iteration,
                           const std::vector<PlanQuality>& qualities) {
  Json tasks = Json::object();
  for (std::size_t k = 0; k < label.tasks.size(); ++k) {
    const TaskIterate& own = iteration.tasks[k];
    tasks[problem.task(label.tasks[k]).name] = {{"F", own.value},
                                                {"speed_reached", qualities[k].speed_reached},
                                                {"newton_iterations", own.newton_iterations},
                                                {"motion_status", to_string(own.motion_status)}};
  }
  return {{"event", "iteration"},
          {"start", label.start},
          {"alone", label.tasks.size() < static_cast<std::size_t>(problem.task_count())},
          {"index", iteration.index},
          {"F", iteration.value},
          {"tasks", tasks},
          {"s", by_name(problem.robot.space, iteration.s)},
          {"design_gradient_norm", iteration.projected_gradient_norm},
          {"design_step", iteration.design_step},
          {"seconds", iteration.seconds}};
}

}  // namespace legwright
