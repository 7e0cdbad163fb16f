// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <thread>

#include "mjcf/text/input_error.hpp"
#include "optimizer/base/stopwatch.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/licence.hpp"
#include "tools/run/certificate_json.hpp"
#include "tools/run/install.hpp"
#include "tools/run/robot_folder.hpp"
#include "tools/run/run_json.hpp"
#include "tools/simulate/stand.hpp"
#include "tools/verbs/close_gap.hpp"
#include "tools/verbs/command_times.hpp"
#include "tools/verbs/explain_changes.hpp"
#include "tools/verbs/feasibility.hpp"
#include "tools/verbs/joint_folders.hpp"
#include "tools/verbs/recorder.hpp"
#include "tools/verbs/stop_signals.hpp"
#include "tools/verbs/summary.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr int kToldConstraints = 3;  // of an infeasible plan

struct OptimizeOptions {
  std::string task, robot, run;
  bool motion_only = false, no_pictures = false, quiet = false, json = false, force = false;
  bool few = false, one_start = false, lbfgs = false, no_certificate = false;
  int max_iterations = CodesignOptions{}.max_iterations;
  int starts = 0, threads = 0, front = 0, physics_steps = 0;
  std::uint64_t seed = 1;
  double few_keeps = 95.0;  // percent of the fall of F
};

std::string status_text(SolveStatus status, int signal) {
  if (signal == SIGINT) return "interrupted";
  return std::string(to_string(status));
}

void draw_rest(PictureQueue& pictures, bool quiet) {
  const std::size_t waiting = pictures.waiting();
  if (!quiet && waiting > 1)
    fmt::print(stderr, "drawing {} more pictures (may be interrupted)\n", waiting);
  while (pictures.waiting() > 0 && StopSignals::received() == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  if (StopSignals::received() != 0) return;
  const std::string warning = pictures.finish();
  if (!warning.empty()) fmt::print(stderr, "legwright: warning: {}\n", warning);
}

int exit_code(int signal, const std::vector<std::string>& reasons) {
  if (signal == SIGINT) return kInterrupted;
  if (signal != 0) return kStoppedEarly;
  return reasons.empty() ? kOk : kInfeasible;
}

MultistartOptions settings_of(const OptimizeOptions& options, int task_count) {
  MultistartOptions settings;
  settings.codesign.max_iterations = options.max_iterations;
  settings.codesign.motion_only = options.motion_only;
  settings.codesign.method = options.lbfgs ? DesignMethod::lbfgs : DesignMethod::newton;
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  settings.codesign.threads = std::min(task_count, options.threads > 0 ? options.threads : cores);
  settings.from_single_tasks = !options.one_start && !options.motion_only;
  settings.perturbations = options.motion_only ? 0 : options.starts;
  settings.seed = options.seed;
  return settings;
}

bool usable(const DesignIteration& iteration) {
  if (iteration.tasks.empty() || !std::isfinite(iteration.value)) return false;
  for (const TaskIterate& task : iteration.tasks)
    if (task.m.size() == 0 || !task.m.allFinite()) return false;
  return true;
}

/// What is on disk and known of each task when the solvers are done.
std::vector<TaskOutcome> write_results(const ResultFolder& folder, const CodesignProblem& problem,
                                       const MultistartResult& found, Recorder& recorder) {
  const CodesignResult& winner = found.winner();
  const CodesignResult& first = found.joint.front().result;
  std::vector<TaskOutcome> outcomes;
  for (int k = 0; k < problem.task_count(); ++k) {
    TaskOutcome outcome;
    outcome.task = k;
    outcome.initial = &first.initial;
    outcome.best = &winner.best;
    outcome.motion_only_trace = first.motion_only_traces[k];
    const bool good = usable(winner.best);
    if (good) outcome.quality = recorder.result(result_folder(folder, problem, k), winner.best, k);
    outcome.reasons = infeasible_reasons(good, outcome.quality, problem.speed_unit(k));
    if (good && !outcome.reasons.empty())  // which limb, when, by how much
      for (std::string& words : worst_constraints(*problem.objectives[k], winner.best.s,
                                                  winner.best.tasks[k].m, kToldConstraints))
        outcome.reasons.push_back(std::move(words));
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

/// Proves the result and writes certificate.json beside it. @return what run.json says of it
CertificateNote write_certificate(const ResultFolder& folder, const CodesignProblem& problem,
                                  const std::vector<JointTask>& tasks, const DesignIteration& best,
                                  int threads) {
  const Stopwatch watch;
  std::vector<WeightedCost> costs;
  std::vector<int> all;
  for (const JointTask& task : tasks) {
    all.push_back(static_cast<int>(costs.size()));
    costs.push_back(weighted(task, task.weight, {}));
  }
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

void warn(const CodesignProblem& problem) {
  for (const auto& objective : problem.objectives)
    for (const std::string& warning : task_warnings(objective->task(), problem.robot))
      fmt::print(stderr, "legwright: warning: {}{}\n",
                 problem.set.joint() ? objective->task().name + ": " : "", warning);
}

fs::path root_of(const OptimizeOptions& options, const CodesignProblem& problem) {
  if (!options.run.empty()) return options.run;
  return fs::path("runs") / (plain_name(problem.robot.morphology.name) + "-" + problem.set.name);
}

/// What stands in the run's folder before anything is solved. @return run.json
RunRecord write_start(const ResultFolder& folder, const CodesignProblem& problem,
                      bool motion_only) {
  RunRecord run = problem.set.joint() ? start_of_joint_run(command_line(), problem)
                                      : start_of_run(command_line(), problem, 0);
  run.motion_only = motion_only || problem.robot.space.size() == 0;
  write_json(folder.run_json(), json_of(run));
  write_file(folder.inputs() / "task.toml", text_beside_robot(problem.set.text));
  write_robot_files(folder.inputs(), problem.robot.files);
  copy_licences(problem.robot.files.folder(), folder.inputs());
  return run;
}

Progress make_progress(const OptimizeOptions& options, const CodesignOptions& settings,
                       const CodesignProblem& problem) {
  std::vector<std::string> names, units;
  int unknowns = 0;
  for (int k = 0; k < problem.task_count(); ++k) {
    names.push_back(problem.task(k).name);
    units.push_back(problem.speed_unit(k));
    unknowns += problem.objectives[k]->layout().motion_size();
  }
  Progress progress(Progress::mode_for_stderr(options.quiet), settings, names, units,
                    problem.set.outer.empty() ? "F" : "F + J");
  progress.start(fmt::format(
      "{} design parameters, {} motion unknowns; first the motion of the initial design ...",
      problem.robot.space.size(), unknowns));
  return progress;
}

/// The result plays for a second in MuJoCo; what the engine warns of is told and noted.
std::vector<EngineWarningRecord> engine_warnings(const ResultFolder& folder,
                                                 const CodesignProblem& problem) {
  std::vector<EngineWarningRecord> found;
  for (int k = 0; k < problem.task_count(); ++k) {
    const fs::path scene = result_folder(folder, problem, k) / "scene.xml";
    if (!fs::exists(scene)) continue;
    for (const HealthWarning& warning : warnings_in_gait(scene)) {
      found.push_back({problem.task(k).name, warning.text, warning.count, warning.time});
      fmt::print(stderr, "legwright: warning: {}: MuJoCo warns: {}, {} times, first at {:.3g} s\n",
                 scene.string(), warning.text, warning.count, warning.time);
    }
  }
  return found;
}

/// Results, and what run.json says of them.
void write_end(const ResultFolder& folder, const CodesignProblem& problem,
               const MultistartResult& found, int signal, Recorder& recorder, RunRecord& run) {
  std::vector<TaskOutcome> outcomes = write_results(folder, problem, found, recorder);
  RunEffort effort = effort_of(found);
  effort.file_seconds = recorder.seconds();
  run.engine_warnings = engine_warnings(folder, problem);
  const std::string status = status_text(found.winner().status, signal);
  if (problem.set.joint()) {
    finish_joint_run(run, status, found, outcomes, effort, problem);
    write_task_runs(folder, problem, run, found, outcomes, recorder);
    return;
  }
  outcomes[0].history = recorder.history();
  if (found.joint.size() > 1) add_starts(run, found, problem);
  finish_run(run, status, outcomes[0], effort, problem.robot);
}

void check_front(const OptimizeOptions& options, const CodesignProblem& problem) {
  if (options.front > 0 && (problem.task_count() != 2 || options.one_start || options.motion_only))
    throw InputError(problem.set.file.string(), 0, "",
                     fmt::format("--front needs two [[task]] tables, each solved alone (no "
                                 "--one-start, no --motion-only); the file has {}",
                                 problem.task_count()));
}

/// After the adjoint loop: what MuJoCo says of the gaits, and steps that it confirms. Noted in
/// run.json: of each task where there are several.
void close_gaps(const ResultFolder& folder, const CodesignProblem& problem,
                const DesignIteration& best, const OptimizeOptions& options, RunRecord& run) {
  CloseGapOptions rules;
  rules.steps = options.physics_steps;
  rules.threads = options.threads > 0
                      ? options.threads
                      : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  rules.stop = [] { return StopSignals::received() != 0; };
  for (int k = 0; k < problem.task_count(); ++k) {
    const std::string name = problem.set.joint() ? problem.task(k).name + ": " : "";
    rules.tell = [&](const std::string& line) {
      if (!options.quiet) fmt::print(stderr, "{}{}\n", name, line);
    };
    const PhysicsStepsRecord found = close_gap(folder, problem, best, k, rules);
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

/// --force removes the old run first; a robot's meshes and licences are copied after that.
void check_not_in_run(const fs::path& root, const RobotFiles& files) {
  const fs::path run = fs::weakly_canonical(fs::absolute(root));
  std::vector<fs::path> needed;
  for (const AssetFile& asset : files.assets()) needed.push_back(asset.source);
  for (const std::string& licence : licences_in(files.folder()))
    needed.push_back(files.folder() / licence);
  for (const fs::path& file : needed) {
    const fs::path inside = fs::weakly_canonical(fs::absolute(file)).lexically_relative(run);
    if (!inside.empty() && *inside.begin() != "..")
      throw IoError(
          fmt::format("{}: the robot's own files lie in it, like {}; choose another folder "
                      "with -o, or copy the robot elsewhere first",
                      root.string(), inside.string()));
  }
}

/// Solves the problem of a run that has started, and writes what comes of it. @return exit code
int solve_run(const OptimizeOptions& options, CodesignProblem& problem, const fs::path& root,
              const ResultFolder& folder, CommandTimes& times, RunRecord& run) {
  // From here on the run has files of its own: what becomes of the user's does not matter to it.
  problem.robot.files = problem.robot.files.moved_to(folder.inputs() / "robot.xml");
  problem.robot.file = problem.robot.files.file();

  MultistartOptions settings = settings_of(options, problem.task_count());
  Progress progress = make_progress(options, settings.codesign, problem);
  Recorder recorder(folder, problem, progress, !options.no_pictures);
  const StopSignals signals;
  settings.on_iteration = [&](const RunLabel& label, const DesignIteration& iteration) {
    return recorder.iteration(label, iteration);
  };
  recorder.start();
  const ProblemCosts costs(problem);
  times.end_of("reading");
  MultistartResult found = codesign_from_starts(costs.tasks(), problem.robot.space, settings);
  ChangeReasons reasons(problem, options.threads, options.few_keeps / 100.0);
  if (options.few) reasons.keep_fewest(found, settings.on_iteration);
  times.end_of("search");
  progress.finish();
  const int signal = StopSignals::received();
  write_end(folder, problem, found, signal, recorder, run);
  times.end_of("results");
  write_json(folder.run_json(), json_of(run));  // what follows may take a while, and adds to it
  if (signal == 0 && usable(found.winner().best)) {
    reasons.write(folder, found, run);
    times.end_of("reasons");
  }
  if (signal == 0 && !options.no_certificate && usable(found.winner().best)) {
    run.certificate = write_certificate(folder, problem, costs.tasks(), found.winner().best,
                                        settings.codesign.threads);
    times.end_of("certificate");
  }
  if (options.physics_steps > 0 && StopSignals::received() == 0 && usable(found.winner().best)) {
    close_gaps(folder, problem, found.winner().best, options, run);
    times.end_of("physics_steps");
  }
  if (options.front > 0 && StopSignals::received() == 0) {
    CodesignOptions rules = settings.codesign;
    rules.on_iteration = [](const DesignIteration&) { return StopSignals::received() == 0; };
    run.front = write_front(folder, problem, costs.tasks(), found, options.front, rules);
    times.end_of("front");
  }
  recorder.end(run);
  write_json(folder.run_json(), json_of(run));  // complete, should the pictures be interrupted
  if (!options.no_pictures && StopSignals::received() == 0) {
    draw_rest(recorder.pictures(), options.quiet);
    times.end_of("pictures");
  }
  times.add_to(*run.seconds);
  write_json(folder.run_json(), json_of(run));

  if (options.json) fmt::print("{}", to_text(json_of(run)));
  if (!options.json && !options.quiet)
    fmt::print("{}", problem.set.joint() ? joint_summary(run, root) : optimize_summary(run, root));
  std::fflush(stdout);
  return exit_code(StopSignals::received(), *run.reasons);
}

/// Whoever follows a run need not wait for one that was given up.
void note_failure(const ResultFolder& folder, RunRecord& run, const char* why) {
  if (run.status != "running") return;
  run.status = "failed";
  run.failure = clean_utf8(why);
  try {
    write_json(folder.run_json(), json_of(run));
  } catch (const std::exception&) {  // what went wrong first is told
  }
}

int optimize(const OptimizeOptions& options) {
  CommandTimes times;
  CodesignProblem problem = read_problem(options.task, options.robot);
  check_front(options, problem);
  if (!options.quiet) warn(problem);
  const fs::path root = root_of(options, problem);
  if (options.force) check_not_in_run(root, problem.robot.files);
  const ResultFolder folder = ResultFolder::create(root, options.force);
  RunRecord run = write_start(folder, problem, options.motion_only);
  try {
    return solve_run(options, problem, root, folder, times, run);
  } catch (const std::exception& error) {
    note_failure(folder, run, error.what());
    throw;
  }
}

}  // namespace

void add_optimize(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "optimize",
               "Co-design body and gait for a task; write a run folder", optimize);
  verb->add_option("TASK", options->task, "task file (TOML), which names its robot")->required();
  verb->add_option("--robot", options->robot, "MJCF of another robot than the one the task names");
  verb->add_option("-o,--output", options->run, "folder of the run; default: runs/ROBOT-TASK");
  verb->add_flag("--motion-only", options->motion_only,
                 "keep the initial design, optimize its motion");
  verb->add_option("--max-iterations", options->max_iterations, "design iterations at most")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  verb->add_flag("--one-start", options->one_start,
                 "several tasks: start from the initial design only, not from each task's optimum");
  verb->add_option("--starts", options->starts, "further starts from perturbed initial designs")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  verb->add_option("--seed", options->seed, "of the perturbations")->capture_default_str();
  verb->add_option(
          "--front", options->front,
          "two tasks: walk the weights from one to the other over so many points between the ends")
      ->check(CLI::Range(1, 99));
  verb->add_flag("--few", options->few,
                 "hand back the body with the fewest changes that keeps most of the fall of F");
  verb->add_option("--few-keeps", options->few_keeps, "how much of the fall of F [%]")
      ->check(CLI::Range(1.0, 100.0))
      ->capture_default_str();
  verb->add_option("--physics-steps", options->physics_steps,
                   "then so many steps on speed, swing height, period and margins of the gait, "
                   "from roll-outs in MuJoCo; only what they confirm is kept")
      ->check(CLI::Range(0, 100));
  verb->add_option("--threads", options->threads,
                   "tasks solved at the same time; results do not depend on it; default: all cores")
      ->check(CLI::Range(1, 64));
  verb->add_flag("--no-certificate", options->no_certificate,
                 "no result/certificate.json, which costs a fraction of a second per parameter");
  verb->add_flag("--lbfgs", options->lbfgs,
                 "step the design by L-BFGS, as the paper does, instead of Newton's method");
  verb->add_flag("--no-pictures", options->no_pictures, "no frame.png of the iterations");
  verb->add_flag("--force", options->force, "replace the run that the folder holds");
  verb->add_flag("--quiet", options->quiet, "say nothing but errors");
  verb->add_flag("--json", options->json, "print run.json instead of a summary");
}

}  // namespace legwright
