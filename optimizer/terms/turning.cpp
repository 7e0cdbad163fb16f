// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (9), E_Turn: over one cycle the heading changes by the wanted angle.
/// Residual τ(q_T) − τ(q_0) − τᴰ [rad], τ the yaw component of the root's rotation vector.
class Turning final : public LinearTerm {
 public:
  explicit Turning(const TermContext& context) {
    const Layout& layout = context.layout;
    add(0, -1,
        {{layout.pose(layout.knot_count()) + 5, times(1.0, 1)},
         {layout.pose(0) + 5, times(-1.0, 1)}},
        Eigen::VectorXd::Constant(1, context.path.turn_angle()));
  }
  std::string_view name() const override { return "turning"; }
  ResidualUnit unit(int, int) const override { return {1.0, "rad"}; }
};

}  // namespace

std::unique_ptr<Term> make_turning(const TermContext& context) {
  return std::make_unique<Turning>(context);
}

}  // namespace legwright
