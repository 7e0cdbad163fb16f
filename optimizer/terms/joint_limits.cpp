// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Not in the paper: joint angles stay inside the range that the robot's file gives, less the task's margin.
/// Residuals q − lower − margin ≥ 0 and upper − margin − q ≥ 0 [rad], kept by the barrier; joints without a range have
/// none.
class JointLimits final : public LinearTerm {
 public:
  explicit JointLimits(const TermContext& context) {
    const Layout& layout = context.layout;
    const double margin = context.task.joint_margin;
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int a = 0; a < context.morphology.joint_count(); ++a) {
        const Joint& joint = context.morphology.links[a + 1].joint;
        const int slot = layout.pose(i) + 6 + a;
        if (std::isfinite(joint.lower))
          add(i, -1, {{slot, times(1.0, 1)}}, Eigen::VectorXd::Constant(1, joint.lower + margin));
        if (std::isfinite(joint.upper))
          add(i, -1, {{slot, times(-1.0, 1)}}, Eigen::VectorXd::Constant(1, margin - joint.upper));
      }
  }
  std::string_view name() const override { return "joint_limits"; }
  Penalty penalty() const override { return Penalty::barrier; }
};

}  // namespace

std::unique_ptr<Term> make_joint_limits(const TermContext& context) { return std::make_unique<JointLimits>(context); }

}  // namespace legwright
