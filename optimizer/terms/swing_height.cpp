// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "optimizer/motion/cycle_target.hpp"
#include "optimizer/motion/margins.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Not in the paper: between lift-off and touchdown a foot clears the ground, with the profile
/// sin^1.5 of the swing's phase: lands and leaves gently. Residual (e_z − r − height·sin^1.5(π
/// phase))/length at knots that are not planted, of the feet for which the task has no heights of
/// its own (style_foot_height).
class SwingHeight final : public LinearTerm {
 public:
  explicit SwingHeight(const TermContext& context) : length_(context.length) {
    const Layout& layout = context.layout;
    const Gait& gait = context.task.gait;
    const double top = legwright::swing_height(
        context.task, standing_leg(context.morphology, context.space.initial()));
    const int margin = layout.planted_margin();
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int j = 0; j < layout.foot_count(); ++j) {
        if (gait.planted(i, j, margin) || target_of(context.task.foot_heights, j)) continue;
        int first = i, last = i;
        while (!gait.planted(first - 1, j, margin)) --first;
        while (!gait.planted(last + 1, j, margin)) ++last;
        const double phase = (i - first + 1.0) / (last - first + 2.0);
        const double height = top * std::pow(std::sin(std::numbers::pi * phase), 1.5);
        add(i, j, {{layout.foot(i, j) + 2, times(1.0 / context.length, 1)}},
            Eigen::VectorXd::Constant(
                1, (context.morphology.feet[j].radius + height) / context.length));
      }
  }
  std::string_view name() const override { return "swing_height"; }
  ResidualUnit unit(int, int) const override { return {length_, "m"}; }

 private:
  double length_;
};

}  // namespace

std::unique_ptr<Term> make_swing_height(const TermContext& context) {
  return std::make_unique<SwingHeight>(context);
}

}  // namespace legwright
