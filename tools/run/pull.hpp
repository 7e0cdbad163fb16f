// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "optimizer/objective/objective.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {

/// Why a body changed: how much of a task's F each term gave up by each parameter's change, summed
/// along the designs that were accepted. A term's derivative is the total one, along m*(s):
/// dF_t/ds = ∂F_t/∂s + ∂F_t/∂m dm/ds. All terms together make dF/ds, because ∂F/∂m vanishes. From one
/// design to the next its share is the mean of both ends times the change, exact to second order; the
/// rest of what a term really gave up in a long step goes to the parameters in the same ratio.
class PullAlongPath {
 public:
  /// The next accepted design and the task's motion there. The first one only sets the start.
  /// @param sensitivity dm/ds; where it is empty only ∂F_t/∂s is told.
  void add(const Objective& objective, const Eigen::VectorXd& s, const Eigen::VectorXd& m,
           const Eigen::MatrixXd& sensitivity);
  /// Goes on where another path ended.
  void follow(const PullAlongPath& before);

  /// Decrease of F by term (row) and parameter (column); negative: the change cost this term.
  const Eigen::MatrixXd& decrease() const { return decrease_; }

  /// Σ |what a term really gave up − what its derivatives tell|: the part that was spread.
  double spread() const { return spread_; }

  /// {parameter: {term: decrease}}, times `weight`; shares too small to matter are left out.
  Json to_json(const DesignSpace& space, double weight) const;

 private:
  std::vector<std::string_view> terms_;
  std::vector<double> values_;  // of the terms
  double spread_ = 0.0;
  Eigen::VectorXd s_;
  Eigen::MatrixXd share_, decrease_;
};

}  // namespace legwright
