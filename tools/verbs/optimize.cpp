// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "mjcf/text/input_error.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/files/licence.hpp"
#include "tools/run/run_json.hpp"
#include "tools/verbs/optimize_run.hpp"
#include "tools/verbs/resume.hpp"
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

fs::path root_of(const OptimizeOptions& options, const CodesignProblem& problem) {
  if (!options.run.empty()) return options.run;
  return fs::path("runs") / (plain_name(problem.robot.morphology.name) + "-" + problem.set.name);
}

int optimize(const OptimizeOptions& asked) {
  CommandTimes times;
  if (asked.task.empty() && asked.resume.empty())
    throw InputError(
        "optimize needs a TASK, or --resume RUN; `legwright optimize --help` tells more");
  OptimizeOptions options = asked;
  ReadCheckpoint checkpoint{begin_of(asked), {}};
  if (!asked.resume.empty()) {
    check_alone(asked);
    checkpoint = unfinished_search(asked.resume, asked.anyway);
    options = options_of(checkpoint, asked.resume);
    options.run = asked.resume;
    options.force = true;
    if (asked.threads > 0) options.threads = asked.threads;
    options.quiet = asked.quiet;
    options.progress = asked.progress;
    options.json = asked.json;
  }
  CodesignProblem problem = read_problem(options.task, options.robot, options.reach());
  check_options(options, problem);
  RunFollower follower;
  follower.warn = [](const std::string& what) {
    fmt::print(stderr, "legwright: warning: {}\n", what);
  };
  follower.stop_signal = StopSignals::received;
  follower.checkpoint = std::move(checkpoint);
  if (!options.quiet) tell_warnings(problem, follower);
  const fs::path root = root_of(options, problem);
  if (options.force) check_not_in_run(root, problem.robot.files);
  const ResultFolder folder = ResultFolder::create(root, options.force);
  const StopSignals signals;
  const RunRecord run = optimize_into(folder, problem, options, follower, times);
  const bool stands = folder.stand();
  if (!stands)
    follower.warn(root.string() +
                  ": stopped before there was a result; the run that was there stays");
  if (options.json) fmt::print("{}", to_text(json_of(run)));
  if (!options.json && !options.quiet && stands)
    fmt::print("{}", problem.set.joint() ? joint_summary(run, root) : optimize_summary(run, root));
  std::fflush(stdout);
  if (StopSignals::received() != 0 && !options.quiet)
    fmt::print(stderr, "legwright: `legwright optimize --resume {}` goes on from here\n",
               root.string());
  return exit_code(StopSignals::received(), *run.reasons);
}

}  // namespace

void add_optimize(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "optimize",
               "Co-design body and gait for a task; write a run folder", optimize);
  add_options(*verb, *options);
}

}  // namespace legwright
