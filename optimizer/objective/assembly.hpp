// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/objective/derived.hpp"
#include "optimizer/objective/sparsity.hpp"
#include "optimizer/terms/term.hpp"

namespace legwright {

/// Residuals of a term whose elements all are linear, r_row = offset + Σ coefficient ·
/// [s; m; y]_slot, one after another in memory; nothing for other terms.
struct LinearRows {
  struct Entry {
    int slot;
    double coefficient;
  };
  std::vector<Entry> entries;   // zeros left out
  std::vector<int> ends;        // row → where its entries end
  std::vector<double> offsets;  // row → r at zero
  std::vector<int> last_rows;   // element → where its rows end
  std::vector<char> constant;   // element → ElementPlan::constant

  bool empty() const { return last_rows.empty(); }
  int first_row(int element) const {
    return element > 0 ? last_rows[static_cast<std::size_t>(element) - 1] : 0;
  }
  /// Where a row's entries begin.
  const Entry* begin(int row) const {
    return entries.data() + (row > 0 ? ends[static_cast<std::size_t>(row) - 1] : 0);
  }
  const Entry* end(int row) const { return entries.data() + ends[static_cast<std::size_t>(row)]; }
  double residual(int row, const double* x) const {
    double sum = offsets[static_cast<std::size_t>(row)];
    for (const Entry* e = begin(row); e != end(row); ++e) sum += e->coefficient * x[e->slot];
    return sum;
  }
};

/// Where one element's local variables go: straight to a column of its clique, or through the
/// Jacobian of a derived quantity to several (chain rule).
struct ElementPlan {
  struct Direct {
    int variable, column;
  };
  /// Neighbouring columns of a block that are neighbours in the clique too.
  struct Run {
    int from, to, count;  // block column, clique column
  };
  struct Through {
    int variable, block, size;
    std::vector<Run> runs;  // rising; design columns, if any, have runs of their own
  };
  std::vector<Direct> direct;
  std::vector<Through> through;
  Clique clique;
  bool constant = false;  // its Hessian is the same everywhere: ½ r² of a linear r of m alone
  bool reaches_design = false;  // its clique has design columns
};

/// @param block_at_slot derived block that starts at a slot of the extended vector, or −1.
/// @param parameter_count size of p; slots from there on are derived and must come as whole blocks.
ElementPlan plan_element(const Term& term, int element, const DerivedBlocks& blocks,
                         const std::vector<int>& block_at_slot, int design_size,
                         int parameter_count);

/// Of a term with constant Jacobians, else nothing. @param plans by element.
LinearRows linear_rows(const Term& term, const std::vector<ElementPlan>& plans);

/// One local variable as a function of the clique's columns: a unit vector or a column of a block's
/// Jacobian.
struct LocalRow {
  int column = 0;  // of a direct variable
  const ElementPlan::Through* through = nullptr;
  const double* chain = nullptr;
};

/// Scratch of one element; sizes grow to the largest and stay.
struct ElementWorkspace {
  Eigen::VectorXd z, residual, multiplier, second, sum;
  Eigen::MatrixXd jacobian, curvature;
  Eigen::MatrixXd expanded;  // columns of the clique × rows
  Eigen::MatrixXd hessian;   // of the clique, lower triangle
  std::vector<LocalRow> rows;
};

/// Writes (J·E)ᵀ into workspace.expanded (the first `columns` of the clique × rows), where E is the
/// Jacobian of the element's local variables in the clique's slots. @param J rows × local
/// variables.
/// @param jacobians by derived block, columns × size.
void expand_jacobian(const ElementPlan& plan, const Eigen::MatrixXd& J,
                     const std::vector<Eigen::MatrixXd>& jacobians, int columns,
                     ElementWorkspace& workspace);

/// Sets the lower triangle of workspace.hessian to Σ_k second_k e_k e_kᵀ, e_k the columns of
/// workspace.expanded.
void rank_hessian(ElementWorkspace& workspace);

/// Adds Eᵀ C E to the lower triangle of workspace.hessian, C = workspace.curvature in the local
/// variables.
void expand_curvature(const ElementPlan& plan, const std::vector<Eigen::MatrixXd>& jacobians,
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
