// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "tools/task/problem.hpp"

namespace legwright {

/// What Python is told of an accepted iterate: a copy, which outlives the search.
struct PythonIteration {
  int index = 0;
  std::string start;               // of the search that it belongs to: "initial", "pace", …
  std::vector<std::string> tasks;  // of that search
  double value = 0.0;              // Σ wᵢ (Fᵢ + Jᵢ)
  Eigen::VectorXd s;
  std::map<std::string, double> terms;  // Σ wᵢ term of Fᵢ
  double projected_gradient_norm = 0.0;
  double seconds = 0.0;
};

PythonIteration python_iteration(const CodesignProblem& problem, const RunLabel& label,
                                 const DesignIteration& iteration);

}  // namespace legwright
