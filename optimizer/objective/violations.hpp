// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "optimizer/objective/objective.hpp"

namespace legwright {

/// The worst place of one constraint at one point (s, m), in physical units.
struct Violation {
  std::string_view term;
  std::string_view equation;
  int knot = 0;
  std::string
      where;  // the foot, the joint or the pair of limbs; empty where it is about the whole robot
  double amount =
      0.0;  // by how much it is broken; negative: how far an inequality is from its wall
  std::string_view unit;  // "m", "N", "rad", "N m", or empty for shares
  double relative = 0.0;  // amount in the term's own scale, to compare terms with
};

/// Each constraint of F (registry role `constraint`, weight above zero) with its worst element,
/// worst first by `relative`. Equalities: the norm of the residual's rows that share a unit.
/// Inequalities: minus the smallest slack. Sizes of s and m as in Objective::evaluate.
std::vector<Violation> worst_violations(const Objective& objective, const Eigen::VectorXd& s,
                                        const Eigen::VectorXd& m);

/// Every element of a constraint that is broken by more than `least` in the term's own scale, term
/// by term, and knot by knot within it.
std::vector<Violation> broken_elements(const Objective& objective, const Eigen::VectorXd& s,
                                       const Eigen::VectorXd& m, double least);

}  // namespace legwright
