// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/optimize_results.hpp"

#include <fmt/format.h>

#include <cmath>
#include <csignal>
#include <memory>
#include <optional>

#include "mjcf/propose/home_touches.hpp"
#include "optimizer/base/stopwatch.hpp"
#include "tools/choose/tightened_text.hpp"
#include "tools/files/licence.hpp"
#include "tools/run/certificate_json.hpp"
#include "tools/run/robot_folder.hpp"
#include "tools/run/run_json.hpp"
#include "tools/simulate/stand.hpp"
#include "tools/task/task_text.hpp"
#include "tools/verbs/feasibility.hpp"
#include "tools/verbs/joint_folders.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr int kToldConstraints = 3;  // of an infeasible plan

/// What is on disk and known of each task when the solvers are done.
std::vector<TaskOutcome> write_results(const ResultFolder& folder, const CodesignProblem& problem,
                                       const MultistartResult& found, const Candidate& chosen,
                                       Recorder& recorder) {
  const DesignIteration& design = chosen.design;
  const CodesignResult& first = found.joint.front().result;
  std::vector<TaskOutcome> outcomes;
  for (int k = 0; k < problem.task_count(); ++k) {
    TaskOutcome outcome;
    outcome.task = k;
    outcome.initial = &first.initial;
    outcome.best = &design;
    outcome.motion_only_trace = first.motion_only_traces[k];
    const bool good = usable(design);
    const std::shared_ptr<const Objective> planned = chosen.objective(problem, k);
    if (good)
      outcome.quality = recorder.result(result_folder(folder, problem, k), *planned, design, k);
    outcome.reasons = infeasible_reasons(good, outcome.quality, problem.speed_unit(k));
    if (good && !outcome.reasons.empty())  // which limb, when, by how much
      for (std::string& words :
           worst_constraints(*planned, design.s, design.tasks[k].m, kToldConstraints))
        outcome.reasons.push_back(std::move(words));
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

/// The result plays for a second in MuJoCo; what the engine warns of is told and noted.
std::vector<EngineWarningRecord> engine_warnings(
    const ResultFolder& folder, const CodesignProblem& problem,
    const std::function<void(const std::string&)>& warn) {
  std::vector<EngineWarningRecord> found;
  for (int k = 0; k < problem.task_count(); ++k) {
    const fs::path scene = result_folder(folder, problem, k) / "scene.xml";
    if (!fs::exists(scene)) continue;
    for (const HealthWarning& warning : warnings_in_gait(scene)) {
      found.push_back({problem.task(k).name, warning.text, warning.count, warning.time});
      warn(fmt::format("{}: MuJoCo warns: {}, {} times, first at {:.3g} s",
                       folder.in_the_end(scene).string(), warning.text, warning.count,
                       warning.time));
    }
  }
  return found;
}

/// What of the result is inside each other in its home pose that was not in the robot's.
void tell_home_touches(const ResultFolder& folder, const CodesignProblem& problem,
                       const std::function<void(const std::string&)>& warn) {
  const fs::path robot = result_folder(folder, problem, 0) / "robot.xml";
  if (!fs::exists(robot)) return;
  const auto touches = new_home_touches(folder.inputs() / "robot.xml", robot);
  if (!touches.empty())
    warn(fmt::format("{}: {}", folder.in_the_end(robot).string(), describe(touches)));
}

}  // namespace

std::string status_text(SolveStatus status, int signal) {
  if (signal != 0) return "interrupted";
  return std::string(to_string(status));
}

RunRecord write_start(const ResultFolder& folder, CodesignProblem& problem, bool motion_only,
                      const std::vector<std::string>& command) {
  gather(problem.robot);
  RunRecord run = problem.set.joint() ? start_of_joint_run(command, problem)
                                      : start_of_run(command, problem, 0);
  run.motion_only = motion_only || problem.robot.space.size() == 0;
  write_json(folder.run_json(), json_of(run));
  write_file(folder.inputs() / "task.toml", text_beside_robot(problem.set.text));
  write_robot_files(folder.inputs(), problem.robot.files);
  copy_licences(problem.robot.files.folder(), folder.inputs());
  problem.robot.files = problem.robot.files.moved_to(folder.inputs() / "robot.xml");
  problem.robot.file = problem.robot.files.file();
  return run;
}

bool usable(const DesignIteration& iteration) {
  if (iteration.tasks.empty() || !std::isfinite(iteration.value)) return false;
  for (const TaskIterate& task : iteration.tasks)
    if (task.m.size() == 0 || !task.m.allFinite()) return false;
  return true;
}

void write_end(const ResultFolder& folder, const CodesignProblem& problem,
               const MultistartResult& found, const Candidate& chosen, bool was_to_play,
               const std::string& status, Recorder& recorder, RunRecord& run,
               const std::function<void(const std::string&)>& warn) {
  std::vector<TaskOutcome> outcomes = write_results(folder, problem, found, chosen, recorder);
  for (TaskOutcome& outcome : outcomes) {
    std::optional<std::string> words;
    if (run.choice)
      words = run.choice->complaint(run.choice->chosen, problem.task(outcome.task).name);
    else if (was_to_play)
      words = "MuJoCo was not asked: the run was interrupted before";
    if (words) outcome.reasons.push_back(std::move(*words));
  }
  RunEffort effort = effort_of(found);
  effort.file_seconds = recorder.seconds();
  run.engine_warnings = engine_warnings(folder, problem, warn);
  tell_home_touches(folder, problem, warn);
  if (problem.set.joint()) {
    finish_joint_run(run, status, found, outcomes, effort, problem);
    write_task_runs(folder, problem, run, found, outcomes, recorder);
    return;
  }
  outcomes[0].history = recorder.history();
  if (found.joint.size() > 1) add_starts(run, found, problem);
  finish_run(run, status, outcomes[0], effort, problem.robot);
}

void write_candidates(const ResultFolder& folder, const CodesignProblem& problem,
                      const ChosenDesign& choice, ChoiceRecord& record) {
  for (const auto& [index, candidate] : choice.kept) {
    const std::string name = fmt::format("candidates/{:02}", index);
    record.candidates.at(index).folder = name;
    fs::create_directories((folder.root() / name).parent_path());
    for (int k = 0; k < problem.task_count(); ++k) {
      fs::path to = folder.root() / name;
      if (problem.set.joint()) {
        fs::create_directories(to);
        to /= problem.task(k).name;
      }
      write_design(to, problem.robot, *candidate.objective(problem, k), candidate.design, k,
                   Durability::process);
    }
    if (candidate.tightening.empty()) continue;
    const std::string task =
        tightened_text(problem, candidate.tightening, "../../inputs/robot.xml");
    if (!task.empty()) write_file(folder.root() / name / kTightenedTask, task, Durability::process);
  }
}

CertificateNote write_certificate(const ResultFolder& folder, const CodesignProblem& problem,
                                  const std::vector<JointTask>& tasks, const Candidate& chosen,
                                  int threads) {
  const Stopwatch watch;
  std::vector<WeightedCost> costs;
  std::vector<int> all;
  std::vector<std::shared_ptr<const Objective>> objectives;
  std::vector<std::unique_ptr<ObjectiveCost>> planned;
  for (const JointTask& task : tasks) {
    const auto k = static_cast<int>(costs.size());
    all.push_back(k);
    objectives.push_back(chosen.objective(problem, k));
    planned.push_back(std::make_unique<ObjectiveCost>(*objectives.back()));
    costs.push_back(weighted(task, task.weight, {}));
    costs.back().cost = planned.back().get();
  }
  const DesignIteration& best = chosen.design;
  CertificateOptions options;
  options.threads = threads;
  const Certificate proof = certify(costs, problem.robot.space, best, options);
  write_json(folder.result() / "certificate.json",
             json_of(certificate_record(problem, best, proof, all)));
  if (problem.set.joint())
    for (int k : all)
      write_json(result_folder(folder, problem, k) / "certificate.json",
                 json_of(certificate_record(problem, best, proof, {k})));
  return {proof.worst_gradient_error(), proof.active.size(), watch.seconds()};
}

void close_gaps(const ResultFolder& folder, const CodesignProblem& problem, const Candidate& chosen,
                const CloseGapOptions& options, RunRecord& run) {
  CloseGapOptions of_task = options;
  for (int k = 0; k < problem.task_count(); ++k) {
    const std::string name = problem.set.joint() ? problem.task(k).name + ": " : "";
    of_task.tell = [&](const std::string& line) {
      if (options.tell) options.tell(name + line);
    };
    of_task.checkpoint = options.checkpoint.in(k);
    const PhysicsStepsRecord found = close_gap(folder, problem, chosen, k, of_task);
    if (!problem.set.joint()) {
      run.physics_steps = found;
      write_json(folder.run_json(), json_of(run));
      continue;
    }
    run.tasks->at(static_cast<std::size_t>(k)).physics_steps = found;
    write_json(folder.run_json(), json_of(run));  // result/ of this task is another one now
    const fs::path own = result_folder(folder, problem, k).parent_path() / "run.json";
    auto task_run = read_record_file<RunRecord>(own);
    task_run.physics_steps = found;
    write_json(own, json_of(task_run));
  }
}

}  // namespace legwright
