// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/element_plan.hpp"

#include <algorithm>

namespace legwright {

ElementPlanner::ElementPlanner(const DerivedBlocks& blocks, int extended_size, int design_size,
                               int parameter_count)
    : blocks_(blocks),
      block_at_slot_(static_cast<std::size_t>(extended_size), -1),
      design_size_(design_size),
      parameter_count_(parameter_count) {
  std::map<std::pair<int, std::vector<int>>, int> first;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const int index = static_cast<int>(b);
    block_at_slot_[static_cast<std::size_t>(blocks[b]->slot())] = index;
    alike_.push_back(
        first.emplace(std::pair(blocks[b]->size(), blocks[b]->slots()), index).first->second);
  }
}

PlannedElement ElementPlanner::plan(const Term& term, int index) {
  const Element& element = term.elements()[static_cast<std::size_t>(index)];
  PlannedElement out;
  std::vector<int> reached;  // slot of a direct variable, −1 − block of those alike
  for (const int slot : element.slots) {
    const int block = block_at_slot_[static_cast<std::size_t>(slot)];
    if (slot < parameter_count_) {
      reached.push_back(slot);
    } else if (block >= 0) {
      out.blocks.push_back(block);
      reached.push_back(-1 - alike_[static_cast<std::size_t>(block)]);
    } else {
      reached.push_back(parameter_count_);  // within a block
    }
  }
  std::shared_ptr<const ElementPlan>& plan = plans_[std::move(reached)];
  if (!plan) plan = make_plan(element);
  out.plan = plan;
  out.constant = term.constant_jacobian(index) != nullptr && term.penalty() == Penalty::quadratic &&
                 plan->through.empty() && !plan->reaches_design();
  return out;
}

std::shared_ptr<const ElementPlan> ElementPlanner::make_plan(const Element& element) {
  const auto block_at = [this](int slot) {
    const int block = block_at_slot_[static_cast<std::size_t>(slot)];
    return block >= 0 ? blocks_[static_cast<std::size_t>(block)].get() : nullptr;
  };
  std::vector<int> slots;
  for (const int slot : element.slots) {
    if (slot < parameter_count_)
      slots.push_back(slot);
    else if (const DerivedQuantity* block = block_at(slot))
      slots.insert(slots.end(), block->slots().begin(), block->slots().end());
  }
  auto plan = std::make_shared<ElementPlan>();
  plan->clique = clique_of(std::move(slots));
  std::vector<std::pair<int, int>> column_of;  // slot → clique column
  for (std::size_t k = 0; k < plan->clique->slots.size(); ++k)
    column_of.emplace_back(plan->clique->slots[k], static_cast<int>(k));
  std::sort(column_of.begin(), column_of.end());
  for (int v = 0; v < static_cast<int>(element.slots.size()); ++v) {
    const int slot = element.slots[static_cast<std::size_t>(v)];
    if (slot < parameter_count_) {
      plan->direct.push_back(
          {v, std::lower_bound(column_of.begin(), column_of.end(), std::pair(slot, 0))->second});
    } else if (const DerivedQuantity* block = block_at(slot)) {
      plan->through.push_back({v, block->size(), runs_of(*block, column_of)});
    }
  }
  return plan;
}

std::shared_ptr<const Clique> ElementPlanner::clique_of(const DerivedQuantity& block) {
  return clique_of(block.slots());
}

std::shared_ptr<const Clique> ElementPlanner::clique_of(std::vector<int> slots) {
  std::sort(slots.begin(), slots.end(), [n = design_size_](int a, int b) {
    const bool a_design = a < n, b_design = b < n;
    return a_design != b_design ? b_design : a < b;
  });
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  std::shared_ptr<Clique>& clique = clique_by_slots_[slots];
  if (!clique) {
    const auto motion =
        std::count_if(slots.begin(), slots.end(), [&](int s) { return s >= design_size_; });
    clique = std::make_shared<Clique>(std::move(slots), static_cast<int>(motion));
    cliques_.push_back(clique);
  }
  return clique;
}

std::vector<ElementPlan::Run> ElementPlanner::runs_of(
    const DerivedQuantity& block, const std::vector<std::pair<int, int>>& column_of) const {
  std::vector<ElementPlan::Run> runs;
  for (std::size_t k = 0; k < block.slots().size(); ++k) {
    const int slot = block.slots()[k], from = static_cast<int>(k);
    const int to = std::lower_bound(column_of.begin(), column_of.end(), std::pair(slot, 0))->second;
    const bool joins = !runs.empty() && runs.back().to + runs.back().count == to &&
                       (slot < design_size_) == (block.slots()[k - 1] < design_size_);
    if (joins)
      ++runs.back().count;
    else
      runs.push_back({from, to, 1});
  }
  return runs;
}

}  // namespace legwright
