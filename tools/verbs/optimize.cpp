// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "mjcf/text/input_error.hpp"
#include "optimizer/base/stopwatch.hpp"
#include "tools/choose/choose_design.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/licence.hpp"
#include "tools/run/install.hpp"
#include "tools/run/robot_folder.hpp"
#include "tools/run/run_json.hpp"
#include "tools/verbs/command_times.hpp"
#include "tools/verbs/explain_changes.hpp"
#include "tools/verbs/joint_folders.hpp"
#include "tools/verbs/optimize_options.hpp"
#include "tools/verbs/optimize_results.hpp"
#include "tools/verbs/recorder.hpp"
#include "tools/verbs/stop_signals.hpp"
#include "tools/verbs/summary.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

int exit_code(int signal, const std::vector<std::string>& reasons) {
  if (signal == SIGINT) return kInterrupted;
  if (signal != 0) return kStoppedEarly;
  return reasons.empty() ? kOk : kInfeasible;
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

void check_front(const OptimizeOptions& options, const CodesignProblem& problem) {
  if (options.front > 0 && (problem.task_count() != 2 || options.one_start || options.motion_only))
    throw InputError(problem.set.file.string(), 0, "",
                     fmt::format("--front needs two [[task]] tables, each solved alone (no "
                                 "--one-start, no --motion-only); the file has {}",
                                 problem.task_count()));
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
  const CloseGapOptions gaps = gap_options(options);
  Progress progress = make_progress(options, settings.codesign, problem);
  Recorder recorder(folder, problem, progress, !options.no_pictures);
  const StopSignals signals;
  std::vector<DesignIteration> along;  // of the whole problem
  settings.on_iteration = [&](const RunLabel& label, const DesignIteration& iteration) {
    const bool whole = static_cast<int>(label.tasks.size()) == problem.task_count();
    if (whole) along.push_back(iteration);
    const bool low_enough = whole && options.stop_at && iteration.value <= *options.stop_at;
    return recorder.iteration(label, iteration) && !low_enough;
  };
  recorder.start();
  const ProblemCosts costs(problem, first_motion_of(options));
  times.end_of("reading");
  MultistartResult found = codesign_from_starts(costs.tasks(), problem.robot.space, settings);
  ChangeReasons reasons(problem, options.threads, options.few_keeps / 100.0, !options.plan_only);
  if (options.few) reasons.keep_fewest(found, settings.on_iteration);
  times.end_of("search");
  progress.finish();
  const int signal = StopSignals::received();
  Candidate chosen{"optimum", found.winner().best, {}, {}};
  if (signal == 0 && !options.plan_only && usable(chosen.design)) {
    ChoiceOptions how = choice_options(options, settings);
    how.space = reasons.space_of_fewest();
    ChosenDesign choice = choose_design(problem, costs.tasks(), found, along, how);
    run.choice = choice.record;
    write_candidates(folder, problem, choice, *run.choice);
    chosen = std::move(choice.result);
    times.end_of("physics");
  }
  write_end(folder, problem, found, chosen, signal, recorder, run);
  times.end_of("results");
  if (!StopSignals::asked() && !options.no_reasons && usable(chosen.design)) {
    reasons.write(folder, found, chosen, run);
    times.end_of("reasons");
  }
  write_json(folder.run_json(), json_of(run));  // what follows may take a while, and adds to it
  if (!StopSignals::asked() && !options.no_certificate && usable(chosen.design)) {
    run.certificate =
        write_certificate(folder, problem, costs.tasks(), chosen, settings.codesign.threads);
    times.end_of("certificate");
  }
  if (gaps.steps > 0 && !StopSignals::asked() && usable(chosen.design)) {
    close_gaps(folder, problem, chosen.design, gaps, run);
    times.end_of("physics_steps");
  }
  if (options.front > 0 && !StopSignals::asked()) {
    CodesignOptions rules = settings.codesign;
    rules.on_iteration = [](const DesignIteration&) { return !StopSignals::asked(); };
    run.front = write_front(folder, problem, costs.tasks(), found, options.front, rules);
    times.end_of("front");
  }
  recorder.end(run);
  write_json(folder.run_json(), json_of(run));  // complete, should the pictures be interrupted
  if (!options.no_pictures && !StopSignals::asked()) {
    recorder.draw_rest(options.quiet);
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
  add_options(*verb, *options);
}

}  // namespace legwright
