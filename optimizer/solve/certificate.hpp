// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/solve/codesign.hpp"

namespace legwright {

struct CertificateOptions {
  double step = 1e-5;          // of the central differences [natural units of the parameters]
  double tolerance = 1e-9;     // scaled stationarity of re-solved motions
  int newton_iterations = 60;  // limit of each
  int threads = 1;             // at most one per task is of use
};

/// The proof of one task at a design.
struct TaskCertificate {
  double stationarity = 0.0;  // max |G·unit|
  SolveStatus motion_status = SolveStatus::iteration_limit;
  bool minimum_in_motion = false;  // ∂G/∂m factors positive: all its curvatures are
  double adjoint_residual = 0.0;   // of eq (7)
  Eigen::VectorXd adjoint;         // d(F + J)/ds by eq (8); empty without a minimum
  Eigen::VectorXd difference;      // the same by central differences of re-solved motions
  Eigen::VectorXd error;           // |adjoint − difference|·unit of each parameter
  double largest = 0.0;            // max |adjoint·unit|
  bool resolved = false;           // all re-solved motions came to rest
};

/// A parameter at one of its hard bounds, and what it would cost to move inwards.
struct ActiveBound {
  int parameter;
  bool upper;
  double gradient;  // of Σ w (F + J) per unit of the parameter
};

/// Evidence that a result is what it says: a minimum over m of each task, and over s within bounds.
struct Certificate {
  std::vector<TaskCertificate> tasks;
  double projected_gradient_norm = 0.0;  // of Σ w (F + J), in natural units
  Eigen::VectorXd curvatures;  // eigenvalues of d²F/ds² over the free parameters, natural
                               // units, rising; empty where it is not known
  std::vector<ActiveBound> active;
  /// Largest error of the adjoint relative to the largest entry of the gradient (or to 1e-3 where
  /// that is smaller: at a minimum there is nothing left to compare with).
  double worst_gradient_error() const;
};

/// Checks an iterate: every adjoint derivative against central differences with the motions solved
/// anew, by the chord method with the factor at the iterate, by Newton's method where that does not
/// come to rest. Costs some 6 n_s gradients per task. Deterministic.
/// @param tasks as for codesign(); initial_motion is not used.
[[nodiscard]] Certificate certify(const std::vector<WeightedCost>& tasks, const DesignSpace& space,
                                  const DesignIteration& iterate,
                                  const CertificateOptions& options = {});

}  // namespace legwright
