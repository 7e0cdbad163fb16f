// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Not in the paper: joints stay near the home pose; tiny weight, so that no direction of m is
/// free. Residual q_i − q_home over the joints [rad], at every knot.
class NominalPose final : public LinearTerm {
 public:
  explicit NominalPose(const TermContext& context) {
    const Layout& layout = context.layout;
    const Eigen::VectorXd nominal = context.morphology.nominal_joints();
    for (int i = 0; i <= layout.knot_count(); ++i)
      add(i, -1, {{layout.pose(i) + 6, times(1.0, context.morphology.joint_count())}}, nominal);
  }
  std::string_view name() const override { return "nominal_pose"; }
  ResidualUnit unit(int, int) const override { return {1.0, "rad"}; }
};

}  // namespace

std::unique_ptr<Term> make_nominal_pose(const TermContext& context) {
  return std::make_unique<NominalPose>(context);
}

}  // namespace legwright
