// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <string_view>
#include <vector>

namespace legwright {

/// A term's share of F.
struct TermValue {
  std::string_view name;
  double value;
};

/// How much of the derivatives is wanted.
enum class Order {
  value,      // F
  gradient,   // + ∂F/∂m
  gradients,  // + ∂F/∂m and ∂F/∂s, no second derivatives: for an outer objective
  hessian,    // + ∂F/∂m and ∂G/∂m, for Newton
  design,     // everything: + ∂F/∂s, ∂G/∂s, ∂²F/∂s², for the adjoint
};

/// Each term's share of the first derivatives, weighted. Rows: terms in registry order; they sum
/// to ∂F/∂s and G. Terms of weight zero have rows of zeros.
struct TermShares {
  std::vector<std::string_view> names;
  Eigen::MatrixXd partial_s;     // terms × design_size
  Eigen::MatrixXd stationarity;  // terms × motion_size; empty unless asked for
};

/// Everything that is known about F at one point (s, m), up to the order that was asked for.
struct Evaluation {
  double value = 0.0;
  std::vector<double> term_values;         // registry order, weighted
  Eigen::VectorXd stationarity;            // G = ∂F/∂m
  Eigen::SparseMatrix<double> hessian_mm;  // ∂G/∂m, lower triangle, fixed pattern
  Eigen::VectorXd partial_s;               // ∂F/∂s at fixed m
  Eigen::MatrixXd hessian_ms;              // ∂G/∂s, motion_size × design_size
  Eigen::MatrixXd hessian_ss;              // ∂²F/∂s²
  std::shared_ptr<const void> pattern;     // whose pattern hessian_mm has
};

}  // namespace legwright
