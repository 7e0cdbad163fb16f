// SPDX-License-Identifier: Apache-2.0
// What an Objective is made of; for the files of this folder only.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "optimizer/design/design.hpp"
#include "optimizer/design/morphology.hpp"
#include "optimizer/motion/layout.hpp"
#include "optimizer/motion/path.hpp"
#include "optimizer/motion/task.hpp"
#include "optimizer/objective/assembly.hpp"
#include "optimizer/objective/derived.hpp"
#include "optimizer/objective/evaluation.hpp"
#include "optimizer/objective/linear_rows.hpp"
#include "optimizer/objective/motion_blocks.hpp"
#include "optimizer/terms/registry.hpp"

namespace legwright {

/// A term of the registry as it stands in an objective.
struct WeightedTerm {
  const TermEntry* entry;
  double weight;
  std::unique_ptr<Term> term;
  std::vector<PlannedElement> plans;  // by element; none where the weight is zero
  LinearRows linear;                  // of the same elements
};

/// Scratch memory of one thread.
struct EvaluationScratch {
  const void* owner = nullptr;  // the objective it was last used with
  DerivedQuantities::Workspace derived;
  ElementWorkspace element;
  Eigen::VectorXd extended, gradient;  // [s; m; y] and ∂F/∂[s; m; y]
  std::vector<int> active;
};

/// All that an Objective knows.
struct ObjectiveParts {
  Morphology morphology;
  DesignSpace space;
  Task task;
  Layout layout;
  WantedPath path;
  Eigen::VectorXd units;
  DerivedQuantities derived;
  std::vector<WeightedTerm> terms;
  std::vector<std::shared_ptr<const Clique>> block_cliques;  // by derived block
  MotionBlocks motion_blocks;
  Eigen::SparseMatrix<double> pattern;  // with the part of ∂G/∂m that is the same everywhere
  std::shared_ptr<const void> pattern_key = std::make_shared<char>();

  void build();
  void plan();
  /// Fills [s; m; y] and clears the gradient.
  void prepare(const Eigen::VectorXd& s, const Eigen::VectorXd& m, Order order,
               EvaluationScratch& workspace) const;
  /// Leaves an element's residual in the workspace, and its z where it is not linear.
  void residual(const WeightedTerm& entry, int index, EvaluationScratch& workspace) const;
  double add_term(const WeightedTerm& entry, Order order, EvaluationScratch& workspace,
                  const HessianTarget& target) const;
  /// A linear element up to first derivatives, and second ones where its rows are of one slot each
  /// (LinearRows::lone); all there is of one whose Hessian stands in `pattern` already.
  double add_linear(const WeightedTerm& entry, int index, Order order, EvaluationScratch& workspace,
                    const HessianTarget& target) const;
  double add_element(const WeightedTerm& entry, int index, Order order,
                     EvaluationScratch& workspace, const HessianTarget& target) const;
  void add_second(const WeightedTerm& entry, int index, Order order, EvaluationScratch& workspace,
                  const HessianTarget& target) const;
  void add_derived(Order order, EvaluationScratch& workspace, const HessianTarget& target) const;
};

}  // namespace legwright
