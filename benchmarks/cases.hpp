// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/task/problem.hpp"

namespace legwright::bench {

/// A row of the paper's Table I.
struct PaperRow {
  int parameters, motion_iterations, design_iterations;
  double seconds;
};

/// An example that is timed, beside the paper's and what is asked of it.
struct Case {
  std::string label;
  std::filesystem::path task_file;
  std::optional<PaperRow> paper;
  double goal_seconds;            // co-design, one core
  double goal_step_milliseconds;  // a motion solve after a design step
};

/// The examples that are timed, and the task of each robot in a folder ROBOTS/NAME/task.toml, by
/// name. @param robots empty: none
std::vector<Case> cases(const std::filesystem::path& examples, const std::filesystem::path& robots);

/// A case with the body that co-design gave it.
struct SolvedCase {
  Case of;
  CodesignProblem problem;
  Eigen::VectorXd s;
  std::vector<Eigen::VectorXd> m;  // per task, m*(s)
};

}  // namespace legwright::bench
