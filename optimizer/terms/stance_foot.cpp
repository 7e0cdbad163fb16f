// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (14), both halves, for a ball foot: while a foot is planted its centre only rolls,
/// e_{i+1} − e_i = r θ_i × ẑ, with θ_i the rotation of its link from knot i to i + 1. Both halves
/// of (14) mean that a foot is planted one knot before and after the knots at which it carries
/// force (or more, Task::planted_margin). Residual over length.
class StanceFoot final : public LinearTerm {
 public:
  explicit StanceFoot(const TermContext& context) : length_(context.length) {
    const Layout& layout = context.layout;
    const double scale = 1.0 / context.length;
    const Gait& gait = context.task.gait;
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int j = 0; j < layout.foot_count(); ++j) {
        if (!gait.planted(i, j, layout.planted_margin()) ||
            !gait.planted(i + 1, j, layout.planted_margin()))
          continue;
        const double r = scale * context.morphology.feet[j].radius;
        Eigen::Matrix3d roll = Eigen::Matrix3d::Zero();  // θ ↦ −r θ × ẑ
        roll(0, 1) = -r;
        roll(1, 0) = r;
        add(i, j,
            {{layout.foot(i + 1, j), times(scale)},
             {layout.foot(i, j), times(-scale)},
             {layout.foot_turn(i, j), roll}},
            Eigen::Vector3d::Zero());
      }
  }
  std::string_view name() const override { return "stance_foot"; }
  ResidualUnit unit(int, int) const override { return {length_, "m"}; }

 private:
  double length_;
};

}  // namespace

std::unique_ptr<Term> make_stance_foot(const TermContext& context) {
  return std::make_unique<StanceFoot>(context);
}

}  // namespace legwright
