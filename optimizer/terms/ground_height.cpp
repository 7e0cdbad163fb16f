// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Not in the paper: a planted foot touches the ground. Residual (e_z − r)/length at planted knots.
class GroundHeight final : public LinearTerm {
 public:
  explicit GroundHeight(const TermContext& context) : length_(context.length) {
    const Layout& layout = context.layout;
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int j = 0; j < layout.foot_count(); ++j)
        if (context.task.gait.planted(i, j, layout.planted_margin()))
          add(i, j, {{layout.foot(i, j) + 2, times(1.0 / context.length, 1)}},
              Eigen::VectorXd::Constant(1, context.morphology.feet[j].radius / context.length));
  }
  std::string_view name() const override { return "ground_height"; }
  ResidualUnit unit(int, int) const override { return {length_, "m"}; }

 private:
  double length_;
};

}  // namespace

std::unique_ptr<Term> make_ground_height(const TermContext& context) {
  return std::make_unique<GroundHeight>(context);
}

}  // namespace legwright
