// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"
#include "tools/verbs/optimize_options.hpp"

namespace legwright {

/// What codesign() of the package asks for.
struct FollowedRun {
  std::string text;               // of the task file
  std::filesystem::path file;     // that messages name; need not exist
  std::filesystem::path folder;   // of the run, made here
  OptimizeOptions options;        // but for task, robot and run, which stand above
  nanobind::object on_iteration;  // called with a PythonIteration; False ends the search; or None
  nanobind::object objective;     // an _objective.AskedObjective, or None
};

/// Runs `legwright optimize` on a thread of its own. The calling thread gives up the interpreter's
/// lock, takes it for on_iteration and the objective, and looks for signals twenty times a second;
/// what these raise, and KeyboardInterrupt, stop the run and are raised once it has stopped. Needs
/// the lock.
/// Throws as read_problem() and optimize_into(). @return what looks doubtful
std::vector<std::string> run_followed(const RobotModel& robot, const FollowedRun& run);

}  // namespace legwright
