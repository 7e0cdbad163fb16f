// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/motion/cycle_target.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (10), the third coordinate of E_StyleEE: a foot is as high over the ground as the task wants
/// it over the cycle. Residual √w (e_z − r − height)/length at the knots at which the foot is not
/// planted, of the feet that have a target; w is the target's own weight. `swing_height` leaves
/// these feet alone.
class StyleFootHeight final : public LinearTerm {
 public:
  explicit StyleFootHeight(const TermContext& context) {
    const Layout& layout = context.layout;
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int j = 0; j < layout.foot_count(); ++j) {
        const CycleTarget* target = target_of(context.task.foot_heights, j);
        if (target == nullptr || context.task.gait.planted(i, j, layout.planted_margin())) continue;
        const double scale = std::sqrt(target->weight) / context.length;
        const double height = target->at(static_cast<double>(i) / layout.knot_count());
        add(i, j, {{layout.foot(i, j) + 2, times(scale, 1)}},
            Eigen::VectorXd::Constant(1, scale * (context.morphology.feet[j].radius + height)));
        sizes_.push_back(1.0 / scale);
      }
  }
  std::string_view name() const override { return "style_foot_height"; }
  ResidualUnit unit(int element, int) const override {
    return {sizes_[static_cast<std::size_t>(element)], "m"};
  }

 private:
  std::vector<double> sizes_;  // of a residual of one, by element [m]
};

}  // namespace

std::unique_ptr<Term> make_style_foot_height(const TermContext& context) {
  return std::make_unique<StyleFootHeight>(context);
}

}  // namespace legwright
