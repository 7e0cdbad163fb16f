// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include <filesystem>
#include <string>

#include "mjcf/read/robot_model.hpp"
#include "tools/task/problem.hpp"
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
  nanobind::object warn;          // called with what looks doubtful, before the search
};

/// Robot and tasks as they are given, ready to be solved. Throws InputError where they do not fit.
/// @param text of the task file @param file that messages name; need not exist
CodesignProblem problem_of(const RobotModel& robot, const std::string& text,
                           const std::filesystem::path& file);

/// Runs `legwright optimize` as a followed call, which asks on_iteration and the objective: what
/// these raise, and KeyboardInterrupt, stop the run and are raised once it has stopped. Needs the
/// lock.
/// Throws as problem_of() and optimize_into().
void run_followed(const RobotModel& robot, const FollowedRun& run);

}  // namespace legwright
