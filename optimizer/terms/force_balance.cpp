// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (13), first half, with the gravity that the paper's print leaves out: Σ_j f_iʲ = M (ẍ_i + g).
/// Residual over the weight; ẍ_i = (x_{i−1} − 2 x_i + x_{i+1})/h². Before knot 0 stands knot T − 1 moved back by one
/// cycle.
class ForceBalance final : public LinearTerm {
 public:
  explicit ForceBalance(const TermContext& context) : weight_(context.weight) {
    const Layout& layout = context.layout;
    const double h = context.task.gait.time_step(),
                 inertia = context.mass / (h * h * context.weight);
    const WantedPath& path = context.path;
    for (int i = 0; i < layout.knot_count(); ++i) {
      Eigen::Vector3d target = context.mass * kGravity / context.weight * Eigen::Vector3d::UnitZ();
      std::vector<Block> blocks{{layout.com(i), times(2 * inertia)},
                                {layout.com(i + 1), times(-inertia)}};
      if (i > 0) {
        blocks.push_back({layout.com(i - 1), times(-inertia)});
      } else {
        const Eigen::Matrix3d back = path.turn().transpose();
        blocks.push_back({layout.com(layout.knot_count() - 1), -inertia * back});
        target -= inertia * back * path.travel();
      }
      for (int j = 0; j < layout.foot_count(); ++j)
        if (layout.force(i, j) >= 0)
          blocks.push_back({layout.force(i, j), times(1.0 / context.weight)});
      add(i, -1, blocks, target);
    }
  }
  std::string_view name() const override { return "force_balance"; }
  ResidualUnit unit(int, int) const override { return {weight_, "N"}; }

 private:
  double weight_;
};

}  // namespace

std::unique_ptr<Term> make_force_balance(const TermContext& context) {
  return std::make_unique<ForceBalance>(context);
}

}  // namespace legwright
