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
  std::string task_file;  // from the folder examples/
  std::optional<PaperRow> paper;
  int least_parameters;                    // s and m
  double ask_seconds, stretch_seconds;     // co-design, one core
  int ask_iterations, stretch_iterations;  // of Newton's method, in the whole co-design
};

/// Which examples are timed: edit here.
std::vector<Case> cases();

/// A case with the body that co-design gave it.
struct SolvedCase {
  Case of;
  CodesignProblem problem;
  Eigen::VectorXd s;
  std::vector<Eigen::VectorXd> m;  // per task, m*(s)
};

}  // namespace legwright::bench
