// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "optimizer/objective/derived/quantity.hpp"
#include "optimizer/objective/sparsity.hpp"
#include "optimizer/terms/term.hpp"

namespace legwright {

/// Where an element's local variables go: straight to a column of its clique, or through the
/// Jacobian of a derived quantity to several (chain rule). Elements that reach the same slots in
/// the same way share it.
struct ElementPlan {
  struct Direct {
    int variable, column;
  };
  /// Neighbouring columns of a block that are neighbours in the clique too.
  struct Run {
    int from, to, count;  // block column, clique column
  };
  struct Through {
    int variable, size;
    std::vector<Run> runs;  // rising; design columns, if any, have runs of their own
  };
  std::vector<Direct> direct;
  std::vector<Through> through;
  std::shared_ptr<const Clique> clique;

  bool reaches_design() const {
    return static_cast<int>(clique->slots.size()) > clique->motion_count;
  }
};

/// An element as it stands in an objective.
struct PlannedElement {
  std::shared_ptr<const ElementPlan> plan;
  std::vector<int> blocks;  // derived block of each of the plan's `through`
  bool constant = false;    // its Hessian is the same everywhere: ½ r² of a linear r of m alone
};

/// Plans elements and derived blocks. A robot of many shapes has ten thousand pairs of capsules
/// whose ends depend on the same few sets of slots: one plan and one clique stand for all alike.
class ElementPlanner {
 public:
  /// @param extended_size of [s; m; y]. @param parameter_count size of [s; m]; slots from there on
  /// are derived and must come as whole blocks.
  ElementPlanner(const DerivedBlocks& blocks, int extended_size, int design_size,
                 int parameter_count);

  PlannedElement plan(const Term& term, int element);
  std::shared_ptr<const Clique> clique_of(const DerivedQuantity& block);
  /// @param slots in any order, also more than once
  std::shared_ptr<const Clique> clique_of(std::vector<int> slots);
  /// Each once, in the order of their first use; for Sparsity::build.
  const std::vector<std::shared_ptr<Clique>>& cliques() const { return cliques_; }

 private:
  std::shared_ptr<const ElementPlan> make_plan(const Element& element);
  std::vector<ElementPlan::Run> runs_of(const DerivedQuantity& block,
                                        const std::vector<std::pair<int, int>>& column_of) const;

  const DerivedBlocks& blocks_;
  std::vector<int> block_at_slot_;  // derived block that starts at a slot of [s; m; y], or −1
  std::vector<int> alike_;          // block → the first one of the same size and slots
  int design_size_, parameter_count_;
  std::map<std::vector<int>, std::shared_ptr<const ElementPlan>> plans_;  // by what is reached how
  std::map<std::vector<int>, std::shared_ptr<Clique>> clique_by_slots_;
  std::vector<std::shared_ptr<Clique>> cliques_;
};

}  // namespace legwright
