// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "tools/run/checkpoint_file.hpp"
#include "tools/run/install.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_record.hpp"
#include "tools/task/problem.hpp"
#include "tools/verbs/command_times.hpp"
#include "tools/verbs/optimize_options.hpp"

namespace legwright {

/// Who follows a co-design run while it goes on.
struct RunFollower {
  /// After an iteration is on disk, on the thread of the run; false ends the search, and the best
  /// so far is what the run goes on with.
  std::function<bool(const RunLabel&, const DesignIteration&)> on_iteration = {};
  /// A sentence on what looks doubtful.
  std::function<void(const std::string&)> warn = [](const std::string&) {};
  /// The signal that asks to stop at once, or 0; asked often and from several threads.
  std::function<int()> stop_signal = [] { return 0; };
  /// What the search goes on from, or an empty state of a new one: as it goes, the run's folder
  /// has how far it is. Nothing: that is not kept.
  std::optional<ReadCheckpoint> checkpoint = {};
  /// What run.json says of who called.
  std::vector<std::string> command = command_line();
};

/// Throws InputError where options ask for what the problem has not.
void check_options(const OptimizeOptions& options, const CodesignProblem& problem);

/// For a run that replaces another, which goes away in the end. Throws IoError where a robot's own
/// meshes and licences lie in its folder.
void check_not_in_run(const std::filesystem::path& root, const RobotFiles& files);

/// Tells what looks doubtful about robot and tasks before anything is solved.
void tell_warnings(const CodesignProblem& problem, const RunFollower& follower);

/// Co-designs a problem into a new run folder: search, choice by physics, reasons, certificate and
/// pictures, as the options ask. On stderr it prints nothing that options.quiet forbids. Where it
/// fails, run.json says so; where the folder is removed meanwhile, it ends. A run that replaces
/// another stands in its place once folder.stand() was called. Throws InputError, IoError,
/// MujocoError, std::system_error.
/// @param problem its robot's files become those of the folder
/// @return run.json as it stands in the end
RunRecord optimize_into(const ResultFolder& folder, CodesignProblem& problem,
                        const OptimizeOptions& options, const RunFollower& follower,
                        CommandTimes& times);

}  // namespace legwright
