// SPDX-License-Identifier: Apache-2.0
#include "python/core/followed_run.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "python/core/iteration.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/task/task_file.hpp"
#include "tools/verbs/optimize_run.hpp"

namespace nb = nanobind;

namespace legwright {
namespace {

constexpr std::chrono::milliseconds kSignalInterval{50};

/// How the thread of the run and the thread that called it talk to each other.
class Conversation {
 public:
  /// The run's thread: hands over an iteration and waits for the answer. @return whether to go on
  bool ask(PythonIteration iteration) {
    std::unique_lock lock(mutex_);
    question_ = std::move(iteration);
    answer_.reset();
    changed_.notify_all();
    changed_.wait(lock, [this] { return answer_.has_value(); });
    return *answer_;
  }
  /// The run's thread: nothing more will come.
  void end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

  /// The calling thread: waits for a question, the end, or a while.
  std::optional<PythonIteration> wait() {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, kSignalInterval, [this] { return ended_ || question_.has_value(); });
    return std::exchange(question_, std::nullopt);
  }
  void answer(bool go_on) {
    const std::lock_guard lock(mutex_);
    answer_ = go_on;
    changed_.notify_all();
  }
  bool ended() {
    const std::lock_guard lock(mutex_);
    return ended_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<PythonIteration> question_;
  std::optional<bool> answer_;
  bool ended_ = false;
};

/// The exception that Python has set, kept until the run has stopped.
class KeptError {
 public:
  /// Calls `work`, which may throw nb::python_error; only the first is kept. @return whether it did
  template <class Work>
  bool caught(Work&& work) {
    try {
      work();
      return false;
    } catch (nb::python_error& error) {
      if (!error_) error_.emplace(std::move(error));
      return true;
    }
  }
  void raise_if_any() {
    if (error_) throw std::move(*error_);
  }

 private:
  std::optional<nb::python_error> error_;
};

/// The run itself, without Python. @return what looks doubtful
std::vector<std::string> optimize_followed(const RobotModel& robot, const FollowedRun& run,
                                           Conversation& conversation, bool asks,
                                           const std::atomic<int>& signal) {
  CommandTimes times;
  std::vector<std::string> warnings;
  TaskSet set = parse_task_tables(run.text, run.file);
  set.robot = robot.file;
  for (TaskFile& task : set.tasks) task.robot = robot.file;
  CodesignProblem problem = make_problem(std::move(set), robot);
  check_options(run.options, problem);
  RunFollower follower;
  follower.warn = [&](const std::string& what) { warnings.push_back(what); };
  follower.stop_signal = [&] { return signal.load(); };
  if (asks)
    follower.on_iteration = [&](const RunLabel& label, const DesignIteration& iteration) {
      return conversation.ask(python_iteration(problem, label, iteration));
    };
  tell_warnings(problem, follower);
  follower.command = {"legwright", "codesign()", "from", "Python"};
  if (run.options.force) check_not_in_run(run.folder, problem.robot.files);
  const ResultFolder folder = ResultFolder::create(run.folder, run.options.force);
  optimize_into(folder, problem, run.options, follower, times);
  return warnings;
}

}  // namespace

std::vector<std::string> run_followed(const RobotModel& robot, const FollowedRun& run) {
  std::vector<std::string> warnings;
  std::exception_ptr failure;
  std::atomic<int> signal{0};
  Conversation conversation;
  KeptError kept;
  const bool asks = !run.on_iteration.is_none();
  {
    const nb::gil_scoped_release released;
    std::thread thread([&] {
      try {
        warnings = optimize_followed(robot, run, conversation, asks, signal);
      } catch (...) {
        failure = std::current_exception();
      }
      conversation.end();
    });
    while (!conversation.ended()) {
      auto question = conversation.wait();
      const nb::gil_scoped_acquire held;
      bool go_on = true;
      const bool failed = kept.caught([&] {
        if (PyErr_CheckSignals() != 0) nb::raise_python_error();
        if (question) go_on = !run.on_iteration(std::move(*question)).is(nb::handle(Py_False));
      });
      if (failed) signal = SIGINT;
      if (question) conversation.answer(go_on && !failed);
    }
    thread.join();
  }
  kept.raise_if_any();
  if (failure) std::rethrow_exception(failure);
  return warnings;
}

}  // namespace legwright
