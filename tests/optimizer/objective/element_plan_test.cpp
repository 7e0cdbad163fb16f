// SPDX-License-Identifier: Apache-2.0
// Elements that are alike share a plan, and it is the one that each has by itself.
#include "optimizer/objective/element_plan.hpp"

#include <gtest/gtest.h>

#include <set>

#include "optimizer/objective/derived.hpp"
#include "optimizer/terms/registry.hpp"
#include "tests/support/term_context.hpp"

namespace legwright {
namespace {

class PlansOfTerms : public testing::TestWithParam<const char*> {
 protected:
  ElementPlanner planner() const {
    return {derived_.blocks(), setting_.layout.extended_size(), setting_.layout.design_size(),
            setting_.layout.parameter_count()};
  }

  const test::TermSetting setting_{true};
  const TermContext context_ = setting_.context();
  const std::unique_ptr<Term> term_ = find_term(GetParam())->make(context_);
  const DerivedQuantities derived_{
      setting_.puppy.morphology, setting_.layout, setting_.task, context_.path,
      std::vector<char>(static_cast<std::size_t>(setting_.layout.extended_size()), 1)};
};

std::vector<std::vector<int>> numbers_of(const ElementPlan& plan) {
  std::vector<std::vector<int>> out{plan.clique->slots, {plan.clique->motion_count}};
  for (const auto& direct : plan.direct) out.push_back({direct.variable, direct.column});
  for (const auto& through : plan.through) {
    out.push_back({through.variable, through.size});
    for (const auto& run : through.runs) out.push_back({run.from, run.to, run.count});
  }
  return out;
}

TEST_P(PlansOfTerms, AreThoseOfEachElementByItself) {
  ElementPlanner all = planner();
  const int count = static_cast<int>(term_->elements().size());
  ASSERT_GT(count, 0);
  for (int e = 0; e < count; ++e) {
    const PlannedElement together = all.plan(*term_, e);
    ElementPlanner alone = planner();
    const PlannedElement itself = alone.plan(*term_, e);
    EXPECT_EQ(numbers_of(*together.plan), numbers_of(*itself.plan)) << "element " << e;
    EXPECT_EQ(together.blocks, itself.blocks);
    EXPECT_EQ(together.constant, itself.constant);
    ASSERT_EQ(together.blocks.size(), together.plan->through.size());
    const std::vector<int>& slots = term_->elements()[static_cast<std::size_t>(e)].slots;
    for (std::size_t k = 0; k < together.blocks.size(); ++k) {
      const auto& block = derived_.blocks()[static_cast<std::size_t>(together.blocks[k])];
      EXPECT_EQ(block->slot(), slots[static_cast<std::size_t>(together.plan->through[k].variable)]);
      EXPECT_EQ(block->size(), together.plan->through[k].size);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Terms, PlansOfTerms,
                         testing::Values("limb_clearance", "torque_balance", "foot_position",
                                         "torque_limits", "smoothness", "joint_limits"));

using PlansOfCapsules = PlansOfTerms;

// Of a robot of many shapes plans were most of the memory and a fifth of the time of a run.
TEST_P(PlansOfCapsules, AreSharedByPairsOfTheSameLinks) {
  ElementPlanner all = planner();
  std::set<const ElementPlan*> plans;
  const std::size_t count = term_->elements().size();
  for (std::size_t e = 0; e < count; ++e)
    plans.insert(all.plan(*term_, static_cast<int>(e)).plan.get());
  EXPECT_LT(plans.size(), count);
  EXPECT_LE(all.cliques().size(), plans.size());
}

INSTANTIATE_TEST_SUITE_P(Pairs, PlansOfCapsules, testing::Values("limb_clearance"));

}  // namespace
}  // namespace legwright
