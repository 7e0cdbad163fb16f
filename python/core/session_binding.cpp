// SPDX-License-Identifier: Apache-2.0
#include "python/core/session_binding.hpp"

#include <nanobind/eigen/dense.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "python/core/calls.hpp"
#include "tools/files/parse_json.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/session/session.hpp"
#include "tools/verbs/optimize_run.hpp"
#include "tools/verbs/save_session.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace legwright {
namespace {

namespace fs = std::filesystem;

std::chrono::milliseconds milliseconds(double seconds) {
  return std::chrono::milliseconds(static_cast<long>(1000.0 * seconds));
}

/// A session that can be closed; calls after that are refused, and those of a forked child, which
/// has the session's memory and not its thread.
class PythonSession {
 public:
  PythonSession(const RobotModel& robot, const std::string& text, const fs::path& file,
                const std::optional<fs::path>& journal, const std::optional<fs::path>& replay,
                int threads) {
    Session::Options options;
    std::error_code none;
    if (replay && journal && fs::equivalent(*replay, *journal, none))
      throw InputError(journal->string(), 0, "journal",
                       "is the journal to obey, which it would replace; name another file");
    if (replay) options.commands = checked_commands(*replay, robot, text);
    if (journal) options.journal = *journal;
    options.threads = threads;
    session_ = std::make_shared<Session>(robot, text, file, options);
    close_at_the_end(session_);
  }
  PythonSession(const PythonSession&) = delete;
  ~PythonSession() {
    if (is_inherited()) (void)new std::shared_ptr<Session>(std::move(session_));  // never ends
  }

  std::shared_ptr<Session> get() const {
    if (is_inherited())  // the lock may be another thread's
      throw nb::value_error(
          "the session belongs to another process, from which this one was forked; open one here");
    const std::lock_guard lock(mutex_);
    if (!session_) throw nb::value_error("the session is closed");
    return session_;
  }
  void close() {
    if (is_inherited()) return;
    std::shared_ptr<Session> gone;
    {
      const std::lock_guard lock(mutex_);
      gone.swap(session_);
    }
    if (gone) gone->close();  // other threads may still be at calls of it
  }

 private:
  /// The commands of a journal of this robot and these tasks.
  static std::vector<SessionCommand> checked_commands(const fs::path& file, const RobotModel& robot,
                                                      const std::string& text) {
    ReadJournal read = read_journal(file);
    const SessionBegin now = begin_of(robot, text, {});
    if (read.begin.robot_sha256 != now.robot_sha256)
      throw InputError(file.string(), 1, "robot",
                       "is another one, or has been changed, since this journal began with " +
                           read.begin.robot.string() + "; give the one that it was");
    if (read.begin.text != text)
      throw InputError(
          file.string(), 1, "text",
          "has other tasks, or other bounds of the robot's parameters, than are given; "
          "give those that the session began with");
    return std::move(read.commands);
  }

  bool is_inherited() const { return ::getpid() != process_; }

  const ::pid_t process_ = ::getpid();
  mutable std::mutex mutex_;
  std::shared_ptr<Session> session_;
};

SessionCommand command_from(const std::string& json) {
  const Json parsed = parse_json(json);
  if (parsed.is_discarded()) throw InputError("<session>", 0, "", "is no JSON: " + json);
  return command_of(parsed, "<session>", 0);
}

std::map<std::string, double> terms_of(const SessionState& state) {
  std::map<std::string, double> terms;
  for (std::size_t k = 0; k < state.weights.size(); ++k)
    for (const TermValue& term : state.now->tasks[k].terms)
      terms[std::string(term.name)] += state.weights[k] * term.value;
  return terms;
}

std::vector<std::string> task_names(const SessionState& state) {
  std::vector<std::string> names;
  for (const TaskFile& task : state.problem->set.tasks) names.push_back(task.name);
  return names;
}

std::vector<std::string> parameter_names(const SessionState& state) {
  std::vector<std::string> names;
  for (const DesignParameter& each : state.problem->robot.space.parameters)
    names.push_back(each.name);
  return names;
}

std::string motion_csv(const SessionState& state, int task) {
  const Objective& objective = *state.problem->objectives.at(static_cast<std::size_t>(task));
  const Eigen::VectorXd& m = state.now->tasks.at(static_cast<std::size_t>(task)).m;
  return design_texts(state.problem->robot, objective, state.s(), m).motion_csv;
}

/// Binds a number or list of the state that a snapshot is of.
template <class Get>
auto of_state(Get get) {
  return [get](const SessionSnapshot& snapshot) { return get(*snapshot.state); };
}

void bind_snapshot(nb::module_& module) {
  const auto free = nb::call_guard<Released>();
  nb::class_<SessionSnapshot>(module, "SessionSnapshot", "Where a session stands.")
      .def_ro("revision", &SessionSnapshot::revision)
      .def_ro("can_undo", &SessionSnapshot::can_undo)
      .def_ro("can_redo", &SessionSnapshot::can_redo)
      .def_ro("names", &SessionSnapshot::names)
      .def_prop_ro("phase",
                   [](const SessionSnapshot& s) { return std::string(to_string(s.phase)); })
      .def_prop_ro("settled", of_state([](const SessionState& s) { return s.settled(); }))
      .def_prop_ro("s", of_state([](const SessionState& s) { return s.s(); }))
      .def_prop_ro("lower", of_state([](const SessionState& s) { return s.lower; }))
      .def_prop_ro("upper", of_state([](const SessionState& s) { return s.upper; }))
      .def_prop_ro("frozen", of_state([](const SessionState& s) { return s.frozen; }))
      .def_prop_ro("parameters", of_state(parameter_names))
      .def_prop_ro("tasks", of_state(task_names))
      .def_prop_ro("weights", of_state([](const SessionState& s) { return s.weights; }))
      .def_prop_ro("F", of_state([](const SessionState& s) { return s.value(); }))
      .def_prop_ro("J", of_state([](const SessionState& s) { return s.outer_value(); }))
      .def_prop_ro("task_F", of_state([](const SessionState& s) {
                     std::vector<double> out;
                     for (const TaskIterate& task : s.now->tasks) out.push_back(task.value);
                     return out;
                   }))
      .def_prop_ro("terms", of_state(terms_of))
      .def_prop_ro("design_gradient",
                   of_state([](const SessionState& s) { return s.design_gradient(); }))
      .def_prop_ro("iterations", of_state([](const SessionState& s) { return s.iterations; }))
      .def(
          "motion_csv",
          [](const SessionSnapshot& snapshot, int task) {
            return motion_csv(*snapshot.state, task);
          },
          "task"_a, free, "The motion of a task as motion.csv has it.");
  nb::class_<SessionEvent>(module, "SessionEvent", "Something that happened in a session.")
      .def_ro("number", &SessionEvent::number)
      .def_ro("words", &SessionEvent::words)
      .def_prop_ro("kind", [](const SessionEvent& e) { return std::string(to_string(e.kind)); })
      .def_prop_ro("snapshot", [](const SessionEvent& e) {
        return std::const_pointer_cast<SessionSnapshot>(e.snapshot);
      });
}

std::vector<std::string> warnings_of(const PythonSession& session) {
  std::vector<std::string> out;
  RunFollower follower;
  follower.warn = [&](const std::string& what) { out.push_back(what); };
  tell_warnings(*session.get()->snapshot()->state->problem, follower);
  return out;
}

}  // namespace

void bind_session(nb::module_& module) {
  bind_snapshot(module);
  const auto free = nb::call_guard<Released>();
  nb::class_<PythonSession>(module, "Session", "tools/session, from any thread.")
      .def(nb::init<const RobotModel&, const std::string&, const fs::path&,
                    const std::optional<fs::path>&, const std::optional<fs::path>&, int>(),
           "robot"_a, "text"_a, "file"_a, "journal"_a.none(), "replay"_a.none(), "threads"_a, free)
      .def(
          "apply",
          [](const PythonSession& s, const std::string& json) {
            s.get()->apply(command_from(json));
          },
          "command"_a, free, "Obeys a command, given as the line of a journal.")
      .def(
          "post",
          [](const PythonSession& s, const std::string& json) {
            s.get()->post(command_from(json));
          },
          "command"_a, free, "The same without waiting.")
      .def(
          "start", [](const PythonSession& s) { s.get()->start(); }, free)
      .def(
          "pause", [](const PythonSession& s) { s.get()->pause(); }, free)
      .def(
          "step", [](const PythonSession& s) { return s.get()->step(); }, free)
      .def(
          "wait",
          [](const PythonSession& s, double seconds) {
            return s.get()->wait(milliseconds(seconds));
          },
          "seconds"_a, free)
      .def("snapshot",
           [](const PythonSession& s) {
             refuse_at_the_end();
             return std::const_pointer_cast<SessionSnapshot>(s.get()->snapshot());
           })
      .def(
          "events",
          [](const PythonSession& s, std::uint64_t after, double seconds) {
            return s.get()->events(after, milliseconds(seconds));
          },
          "after"_a, "seconds"_a, free)
      .def("warnings", warnings_of, free, "What looks doubtful about its tasks.")
      .def(
          "journal", [](const PythonSession& s) { return s.get()->record().journal; }, free)
      .def(
          "save",
          [](const PythonSession& s, const fs::path& folder, bool force) {
            save_session(s.get()->record(), folder, force);
          },
          "folder"_a, "force"_a, free)
      .def("close", &PythonSession::close, free);
}

}  // namespace legwright
