// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Not in the paper: every stance foot carries at least a share of the weight, so that small errors
/// do not lift it. Residual f_z/weight − share ≥ 0, kept by the barrier.
class LeastNormalForce final : public LinearTerm {
 public:
  explicit LeastNormalForce(const TermContext& context) : weight_(context.weight) {
    const Layout& layout = context.layout;
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int j = 0; j < layout.foot_count(); ++j)
        if (layout.force(i, j) >= 0)
          add(i, j, {{layout.force(i, j) + 2, times(1.0 / context.weight, 1)}},
              Eigen::VectorXd::Constant(1, context.task.min_normal));
  }
  std::string_view name() const override { return "least_normal_force"; }
  ResidualUnit unit(int, int) const override { return {weight_, "N"}; }
  Penalty penalty() const override { return Penalty::barrier; }

 private:
  double weight_;
};

}  // namespace

std::unique_ptr<Term> make_least_normal_force(const TermContext& context) {
  return std::make_unique<LeastNormalForce>(context);
}

}  // namespace legwright
