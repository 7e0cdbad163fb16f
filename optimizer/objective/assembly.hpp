// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/objective/element_plan.hpp"

namespace legwright {

/// One local variable as a function of the clique's columns: a unit vector or a column of a block's
/// Jacobian.
struct LocalRow {
  int column = 0;  // of a direct variable
  const ElementPlan::Through* through = nullptr;
  const double* chain = nullptr;
};

/// An entry of an element's curvature in its local variables that is not zero, row ≥ column.
struct CurvatureEntry {
  int row, column;
  double value;
};

/// Scratch of one element; sizes grow to the largest and stay.
struct ElementWorkspace {
  Eigen::VectorXd z, residual, multiplier, second;
  Eigen::MatrixXd jacobian, curvature;
  Eigen::MatrixXd expanded;  // columns of the clique × rows
  Eigen::MatrixXd hessian;   // of the clique, lower triangle
  std::vector<LocalRow> rows;
  std::vector<CurvatureEntry> entries;
  Eigen::MatrixXd local_by_clique, bent;  // E and C E, see expand_curvature
};

/// Writes (J·E)ᵀ into workspace.expanded (the first `columns` of the clique × rows), where E is the
/// Jacobian of the element's local variables in the clique's slots. @param J rows × local
/// variables.
/// @param jacobians by derived block, columns × size.
void expand_jacobian(const PlannedElement& element, const Eigen::MatrixXd& J,
                     const std::vector<Eigen::MatrixXd>& jacobians, int columns,
                     ElementWorkspace& workspace);

/// Sets the lower triangle of workspace.hessian to Σ_k second_k e_k e_kᵀ, e_k the columns of
/// workspace.expanded.
void rank_hessian(ElementWorkspace& workspace);

/// Adds Eᵀ C E to the lower triangle of workspace.hessian, C = workspace.curvature in the local
/// variables.
void expand_curvature(const PlannedElement& element, const std::vector<Eigen::MatrixXd>& jacobians,
                      int columns, ElementWorkspace& workspace);

/// Second derivatives of F by where they go; null where they are not wanted.
struct HessianTarget {
  double* mm;           // values of ∂G/∂m
  Eigen::MatrixXd* ms;  // ∂G/∂s
  Eigen::MatrixXd* ss;  // ∂²F/∂s², lower triangle
  int design_size;
};

/// Adds Σ_k second_k e_k e_kᵀ, e_k the columns of `expanded` (clique columns × rows).
void scatter_rank(const Clique& clique, const Eigen::MatrixXd& expanded,
                  const Eigen::VectorXd& second, const HessianTarget& target);
/// Adds a clique's Hessian, given by its lower triangle.
void scatter(const Clique& clique, const Eigen::MatrixXd& hessian, const HessianTarget& target);

}  // namespace legwright
