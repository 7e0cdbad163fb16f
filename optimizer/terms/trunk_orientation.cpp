// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Style of the pose, in the spirit of eqs (10): the trunk stays level and faces the wanted
/// heading. Residual o_i − (0, 0, heading) [rad] at every knot, o the root's rotation vector.
class TrunkOrientation final : public LinearTerm {
 public:
  explicit TrunkOrientation(const TermContext& context) {
    const Layout& layout = context.layout;
    for (int i = 0; i <= layout.knot_count(); ++i)
      add(i, -1, {{layout.pose(i) + 3, times(1.0)}},
          Eigen::Vector3d(0, 0, context.path.heading(i * context.task.gait.time_step())));
  }
  std::string_view name() const override { return "trunk_orientation"; }
  ResidualUnit unit(int, int) const override { return {1.0, "rad"}; }
};

}  // namespace

std::unique_ptr<Term> make_trunk_orientation(const TermContext& context) {
  return std::make_unique<TrunkOrientation>(context);
}

}  // namespace legwright
