// SPDX-License-Identifier: Apache-2.0
#include "python/core/followed_run.hpp"

#include <csignal>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "python/core/followed_call.hpp"
#include "python/core/iteration.hpp"
#include "python/core/own_objective.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/task/task_file.hpp"
#include "tools/verbs/optimize_run.hpp"
#include "tools/verbs/resume.hpp"

namespace nb = nanobind;

namespace legwright {
namespace {

/// How far its search is: an earlier one's state where it shall go on. Nothing where the objective
/// is a function of the caller's, which may be another one next time.
std::optional<ReadCheckpoint> checkpoint_of(const FollowedRun& run) {
  if (run.objective.is_valid() && !run.objective.is_none()) return std::nullopt;
  if (run.options.resume.empty()) return ReadCheckpoint{begin_of(run.options), {}};
  ReadCheckpoint search = unfinished_search(run.folder, false);
  check_same_options(search, run.options, run.folder);
  return search;
}

/// The run itself, without Python.
void optimize_followed(const RobotModel& robot, const FollowedRun& run, FollowedCall& call) {
  Conversation& conversation = call.conversation;
  std::atomic<int>& signal = call.signal;
  CommandTimes times;
  CodesignProblem problem = problem_of(robot, run.text, run.file);
  if (run.objective.is_valid() && !run.objective.is_none())
    set_own_objective(problem, run.objective, conversation, [&](nb::python_error&& interrupt) {
      call.kept.keep(std::move(interrupt));
      signal = SIGINT;
    });
  check_options(run.options, problem);
  RunFollower follower;
  follower.warn = [&](const std::string& what) {
    if (!conversation.ask([&] { run.warn(what); })) signal = SIGINT;  // warnings may be errors
  };
  follower.stop_signal = [&] { return signal.load(); };
  if (!run.on_iteration.is_none())
    follower.on_iteration = [&](const RunLabel& label, const DesignIteration& iteration) {
      PythonIteration told = python_iteration(problem, label, iteration);
      bool go_on = true;
      const bool done = conversation.ask([&] {
        if (signal != 0) return;
        try {
          go_on = !run.on_iteration(std::move(told)).is(nb::handle(Py_False));
        } catch (nb::python_error&) {
          signal = SIGINT;
          throw;
        }
      });
      return done && go_on && signal == 0;
    };
  tell_warnings(problem, follower);
  if (signal != 0) throw std::runtime_error("stopped before the search");
  follower.command = {"legwright.codesign()"};
  follower.checkpoint = checkpoint_of(run);
  if (run.options.force) check_not_in_run(run.folder, problem.robot.files);
  const ResultFolder folder = ResultFolder::create(run.folder, run.options.force);
  optimize_into(folder, problem, run.options, follower, times);
  if (!folder.stand() && signal == 0)
    throw IoError(run.folder.string() +
                  ": stopped before there was a result; the run that was there stays");
}

}  // namespace

CodesignProblem problem_of(const RobotModel& robot, const std::string& text,
                           const std::filesystem::path& file) {
  TaskSet set = parse_task_tables(text, file);
  set.robot = robot.file;
  for (TaskFile& task : set.tasks) task.robot = robot.file;
  return make_problem(std::move(set), robot);
}

void run_followed(const RobotModel& robot, const FollowedRun& run) {
  FollowedCall call;
  follow(call, [&] { optimize_followed(robot, run, call); });
}

}  // namespace legwright
