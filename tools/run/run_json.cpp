// SPDX-License-Identifier: Apache-2.0
#include "tools/run/run_json.hpp"

#include <limits>

#include "mjcf/read/connectors.hpp"
#include "mjcf/text/safe_path.hpp"
#include "optimizer/design/inertia.hpp"
#include "optimizer/factor/hessian_factor.hpp"
#include "optimizer/motion/faced_frame.hpp"
#include "tools/files/checksum.hpp"
#include "tools/run/by_name.hpp"
#include "tools/run/install.hpp"
#include "tools/task/task_text.hpp"

namespace legwright {
namespace {

std::array<double, 3> numbers_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// What only some tasks have is there only then.
TaskRecord record_of_task(const CodesignProblem& problem, int k) {
  const Task& task = problem.objectives[static_cast<std::size_t>(k)]->task();
  TaskRecord record;
  record.name = task.name;
  record.gait = task.gait.name();
  record.period = task.gait.period();
  record.knots = task.gait.knot_count();
  record.planted_margin = task.planted_margin;
  const TaskFile& wanted = problem.task(k);
  const Eigen::Vector2d velocity = from_facing(wanted.velocity, wanted.forward);
  record.velocity = {velocity.x(), velocity.y()};
  if (wanted.forward != Eigen::Vector2d::UnitX()) record.forward = facing_text(wanted.forward);
  record.turn_rate = wanted.turn_rate;
  record.floor_friction = task.floor_friction;
  if (const SlopeAngles slope = slope_of(task.velocity, task.up);
      slope.along != 0.0 || slope.across != 0.0)
    record.slope = {slope.along, slope.across};
  if (task.payload)
    record.payload = {task.payload->mass, numbers_of(task.payload->position),
                      numbers_of(task.payload->size)};
  record.torque_limit = task.torque_limit;
  record.servo_kp = task.servo_kp;
  if (task.step_over > 0.0) record.step_over = task.step_over;
  if (task.dynamics == Dynamics::constant_inertia) record.dynamics = "constant_inertia";
  return record;
}

/// All but the task or tasks.
RunRecord head(const std::vector<std::string>& argv, const CodesignProblem& problem) {
  RunRecord run;
  run.status = "running";
  run.robot = problem.robot.morphology.name;
  if (!problem.outers.empty()) {
    OuterRecord& outer = run.outer.emplace();
    outer.objective = problem.set.outer;
    if (!problem.set.outer_source.empty()) outer.source = problem.set.outer_source;
    outer.weight = problem.set.outer_weight;
    outer.unit = std::string(problem.outers.front()->unit());
  }
  run.design_size = problem.robot.space.size();
  for (const DesignParameter& p : problem.robot.space.parameters)
    run.parameters.push_back({p.name, p.unit, std::string(to_string(p.kind)), p.sentence, p.initial,
                              p.lower, p.upper, p.initial, p.tied_count});
  run.argv = argv;
  const Json known = versions();  // must outlive the loop over its items
  for (const auto& [name, version] : known.items()) run.versions.emplace_back(name, version);
  run.factorisation = factor_name();
  run.files = {{"task.toml", problem.set.file.string()},
               {"robot.xml", problem.robot.file.string()}};
  const RobotFiles& files = problem.robot.files;
  run.sha256 = {{"task.toml", sha256_hex(problem.set.text)},
                {"inputs/task.toml", sha256_hex(text_beside_robot(problem.set.text))},
                {"robot.xml", sha256_hex(files.main_text())}};
  for (const IncludedFile& included : files.includes())
    run.sha256.of(included.path.generic_string()) = sha256_hex(included.text);
  for (const AssetFile& asset : files.assets())
    run.sha256.of(asset.path.generic_string()) =
        sha256_hex(read_regular_file(asset.source, asset.bytes));
  return run;
}

void add_effort(RunRecord& run, const RunEffort& effort) {
  run.design_iterations = effort.design_iterations;
  run.newton_iterations = effort.newton_iterations;
  run.factorisations = effort.factorisations;
  run.seconds = {{"total", effort.seconds.total},
                 {"motion", effort.seconds.motion},
                 {"adjoint", effort.seconds.adjoint},
                 {"predictor", effort.seconds.predictor},
                 {"files", effort.file_seconds}};
  run.peak_rss_mib = peak_memory_mib();
}

void add_final_design(RunRecord& run, const RobotModel& robot, const Eigen::VectorXd& s) {
  for (int k = 0; k < robot.space.size(); ++k) run.parameters[k].final = s[k];
  run.body = {body_record(robot, robot.space.initial()), body_record(robot, s)};
}

ByName<double> task_values(const CodesignProblem& problem, const RunLabel& label,
                           const DesignIteration& iteration) {
  ByName<double> values;
  for (std::size_t k = 0; k < iteration.tasks.size(); ++k)
    values.emplace_back(problem.task(label.tasks[k]).name, iteration.tasks[k].value);
  return values;
}

StartRecord record_of_start(const CodesignProblem& problem, const StartedRun& run) {
  StartRecord start;
  start.start = run.label.start;
  for (int k : run.label.tasks) start.tasks.push_back(problem.task(k).name);
  start.status = to_string(run.result.status);
  start.start_F = run.result.initial.value;
  start.F = run.result.best.value;
  start.start_F_of_tasks = task_values(problem, run.label, run.result.initial);
  start.F_of_tasks = task_values(problem, run.label, run.result.best);
  start.design_iterations = run.result.design_iterations;
  start.newton_iterations = run.result.newton_iterations;
  start.seconds = run.result.seconds.total;
  start.s = by_name(problem.robot.space, run.result.best.s);
  return start;
}

std::vector<StartRecord> records_of(const CodesignProblem& problem,
                                    const std::vector<StartedRun>& runs) {
  std::vector<StartRecord> starts;
  starts.reserve(runs.size());
  for (const StartedRun& one : runs) starts.push_back(record_of_start(problem, one));
  return starts;
}

}  // namespace

BodyRecord body_record(const RobotModel& robot, const Eigen::VectorXd& s) {
  const Morphology written = with_hulls_at(robot, s);  // as the file at s weighs
  BodyRecord body{GeometryAtDesign(written, s).total_mass, {}};
  double volume = 0.0;
  for (const Link& link : written.links)
    for (const PointMass& point : link.masses) volume += point.volume * point.growth_at(s);
  if (volume > 0.0) body.printed_volume = volume;
  return body;
}

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

RunRecord start_of_run(const std::vector<std::string>& argv, const CodesignProblem& problem,
                       int task) {
  RunRecord run = head(argv, problem);
  run.task = record_of_task(problem, task);
  run.motion_size = problem.objectives[task]->layout().motion_size();
  if (run.outer) run.outer->reference = problem.outers[task]->reference();
  return run;
}

RunRecord start_of_joint_run(const std::vector<std::string>& argv, const CodesignProblem& problem) {
  RunRecord run = head(argv, problem);
  run.name = problem.set.name;
  run.tasks.emplace();
  for (int k = 0; k < problem.task_count(); ++k) {
    TaskRecord task = record_of_task(problem, k);
    task.weight = problem.task(k).weight;
    task.folder = "tasks/" + problem.task(k).name;
    task.motion_size = problem.objectives[k]->layout().motion_size();
    run.motion_size += *task.motion_size;
    run.tasks->push_back(std::move(task));
  }
  return run;
}

void finish_run(RunRecord& run, const std::string& status, const TaskOutcome& outcome,
                const RunEffort& effort, const RobotModel& robot) {
  const TaskIterate& best = outcome.best->tasks.at(outcome.task);
  const PlanQuality& quality = outcome.quality;
  run.status = status;
  run.feasible = outcome.reasons.empty();
  run.reasons = outcome.reasons;
  run.motion_only_F = outcome.initial->tasks.at(outcome.task).value;
  run.motion_only_trace = outcome.motion_only_trace;
  run.final_F = best.value;
  run.final_J = best.outer_value;
  run.final_terms = by_term(best);
  if (run.outer && run.outer->reference && run.outer->weight > 0.0) {
    const double amount = *run.outer->reference / run.outer->weight;  // of J = 1
    run.outer->plan_initial = amount * outcome.initial->tasks.at(outcome.task).outer_value;
    run.outer->plan_final = amount * best.outer_value;
  }
  run.history = outcome.history;
  add_effort(run, effort);
  run.projected_gradient_norm = outcome.best->projected_gradient_norm;
  run.motion_status = to_string(best.motion_status);
  run.speed_wanted = quality.speed_wanted;
  run.speed_reached = quality.speed_reached;
  run.heading_error = quality.heading_error;
  run.ground_error = quality.ground_error;
  run.slide_share = quality.slide_share;
  run.root_residual = quality.root_residual;
  add_final_design(run, robot, outcome.best->s);
}

void add_starts(RunRecord& run, const MultistartResult& result, const CodesignProblem& problem) {
  run.best_start = result.joint[result.best].label.start;
  run.starts = records_of(problem, result.joint);
}

void finish_joint_run(RunRecord& run, const std::string& status, const MultistartResult& result,
                      const std::vector<TaskOutcome>& outcomes, const RunEffort& effort,
                      const CodesignProblem& problem) {
  const DesignIteration& result_design = *outcomes.front().best;
  run.status = status;
  run.reasons.emplace();
  for (const TaskOutcome& outcome : outcomes)
    for (const std::string& reason : outcome.reasons)
      run.reasons->push_back(problem.task(outcome.task).name + ": " + reason);
  run.feasible = run.reasons->empty();
  for (const TaskOutcome& outcome : outcomes) {
    TaskRecord& task = run.tasks->at(static_cast<std::size_t>(outcome.task));
    task.initial_F = outcome.initial->tasks.at(outcome.task).value;
    task.F = outcome.best->tasks.at(outcome.task).value;
    task.speed_wanted = outcome.quality.speed_wanted;
    task.speed_reached = outcome.quality.speed_reached;
    task.feasible = outcome.reasons.empty();
  }
  run.motion_only_F = result.joint.front().result.initial.value;
  run.final_F = result_design.value;
  add_starts(run, result, problem);
  run.alone = records_of(problem, result.alone);
  add_effort(run, effort);
  run.projected_gradient_norm = result_design.projected_gradient_norm;
  add_final_design(run, problem.robot, result_design.s);
}

EndEvent end_event(const RunRecord& run) {
  const double* const total = run.seconds ? run.seconds->find("total") : nullptr;
  return {run.status, run.final_F.value_or(std::numeric_limits<double>::quiet_NaN()),
          total != nullptr ? *total : 0.0};
}

IterationEvent iteration_event(const DesignSpace& space, const DesignIteration& iteration, int task,
                               const PlanQuality& quality) {
  const TaskIterate& own = iteration.tasks.at(task);
  IterationEvent event;
  event.index = iteration.index;
  event.F = own.value;
  event.J = own.outer_value;
  event.terms = by_term(own);
  event.s = by_name(space, iteration.s);
  event.design_gradient_norm = iteration.projected_gradient_norm;
  event.newton_iterations = own.newton_iterations;
  event.motion_status = to_string(own.motion_status);
  event.speed_reached = quality.speed_reached;
  event.design_step = iteration.design_step;
  event.seconds = iteration.seconds;
  return event;
}

JointIterationEvent joint_iteration_event(const CodesignProblem& problem, const RunLabel& label,
                                          const DesignIteration& iteration,
                                          const std::vector<PlanQuality>& qualities) {
  JointIterationEvent event;
  event.start = label.start;
  event.alone = label.tasks.size() < static_cast<std::size_t>(problem.task_count());
  event.index = iteration.index;
  event.F = iteration.value;
  for (std::size_t k = 0; k < label.tasks.size(); ++k) {
    const TaskIterate& own = iteration.tasks[k];
    event.tasks.of(problem.task(label.tasks[k]).name) = {own.value, qualities[k].speed_reached,
                                                         own.newton_iterations,
                                                         std::string(to_string(own.motion_status))};
  }
  event.s = by_name(problem.robot.space, iteration.s);
  event.design_gradient_norm = iteration.projected_gradient_norm;
  event.design_step = iteration.design_step;
  event.seconds = iteration.seconds;
  return event;
}

}  // namespace legwright
