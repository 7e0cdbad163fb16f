// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/objective/derived.hpp"
#include "optimizer/objective/sparsity.hpp"
#include "optimizer/terms/term.hpp"

namespace legwright {

/// Where one element's local variables go: straight to a column of its clique, or through the Jacobian of a
/// derived quantity to several (chain rule).
struct ElementPlan {
  struct Direct {
    int variable, column;
  };
  struct Through {
    int variable;              // first of three
    int block;                 // of DerivedQuantities
    std::vector<int> columns;  // block column → clique column
  };
  std::vector<Direct> direct;
  std::vector<Through> through;
  Clique clique;
};

/// @param block_at_slot derived block that starts at a slot of the extended vector, or −1.
/// @param parameter_count size of p; slots from there on are derived and must come in whole triples.
ElementPlan plan_element(const Element& element, const std::vector<DerivedBlock>& blocks,
                         const std::vector<int>& block_at_slot, int design_size,
                         int parameter_count);

/// Scratch of one element; sizes grow to the largest and stay.
struct ElementWorkspace {
  Eigen::VectorXd z, residual, multiplier, second;
  Eigen::MatrixXd jacobian, curvature, expanded, hessian, row;
};

/// Writes J·E into workspace.expanded (rows × columns of the clique, the first `columns` of them), where E is the
/// Jacobian of the element's local variables in the clique's slots.
void expand_jacobian(const ElementPlan& plan, const std::vector<Eigen::Matrix3Xd>& jacobians,
                     int columns, ElementWorkspace& workspace);

/// Adds Eᵀ C E to workspace.hessian, C the element's curvature in its local variables.
void expand_curvature(const ElementPlan& plan, const std::vector<Eigen::Matrix3Xd>& jacobians,
                      int columns, ElementWorkspace& workspace);

}  // namespace legwright
