// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/files/json_file.hpp"
#include "tools/task/problem.hpp"

namespace legwright {

/// How well exact derivatives of one task's F, and of its outer objective, agree with central
/// differences: largest error relative to the derivative's size, over random directions from a
/// fixed seed.
struct GradientCheck {
  std::string task, point;  // "standing" (m₀) or "solved" (m* of the initial design)
  double motion = 0.0;      // ∂F/∂m against F
  double design = 0.0;      // ∂F/∂s against F
  double hessian_mm = 0.0;  // ∂G/∂m against G
  double hessian_ms = 0.0;  // ∂G/∂s against G
  double adjoint = -1.0;    // dF/ds against re-solved motions; −1 where ∂G/∂m is not positive
};

/// Checks every task at the initial design.
std::vector<GradientCheck> check_gradients(const CodesignProblem& problem);

/// Error above which a check has failed.
inline constexpr double kGradientTolerance = 1e-5;
bool passes(const GradientCheck& check);

std::string to_text(const std::vector<GradientCheck>& checks);
Json to_json(const std::vector<GradientCheck>& checks);

}  // namespace legwright
