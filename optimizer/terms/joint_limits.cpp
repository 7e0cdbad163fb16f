// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Not in the paper: joint angles stay inside the range that the robot's file gives, less the
/// task's margin. Residuals (q − lower − margin)/half ≥ 0 and (upper − margin − q)/half ≥ 0, kept
/// by the barrier, half the range that is left (so that they are one in its middle) or one radian
/// where one side is open; joints without a range have none.
class JointLimits final : public LinearTerm {
 public:
  explicit JointLimits(const TermContext& context) {
    const Layout& layout = context.layout;
    const double margin = context.task.joint_margin;
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int a = 0; a < context.morphology.joint_count(); ++a) {
        const Joint& joint = context.morphology.links[a + 1].joint;
        const int slot = layout.pose(i) + 6 + a;
        const double range = 0.5 * (joint.upper - joint.lower) - margin;
        const double scale = std::isfinite(range) && range > 0.0 ? 1.0 / range : 1.0;
        const auto note = [&] { sides_.push_back({1.0 / scale, joint.name}); };
        if (std::isfinite(joint.lower)) {
          note();
          add(i, -1, {{slot, times(scale, 1)}},
              Eigen::VectorXd::Constant(1, scale * (joint.lower + margin)));
        }
        if (std::isfinite(joint.upper)) {
          note();
          add(i, -1, {{slot, times(-scale, 1)}},
              Eigen::VectorXd::Constant(1, scale * (margin - joint.upper)));
        }
      }
  }
  std::string_view name() const override { return "joint_limits"; }
  Penalty penalty() const override { return Penalty::barrier; }
  ResidualUnit unit(int element, int) const override { return {sides_[element].half, "rad"}; }
  std::string subject(int element, int) const override { return sides_[element].joint; }

 private:
  struct Side {
    double half;  // range that is left [rad]
    std::string joint;
  };
  std::vector<Side> sides_;  // by element
};

}  // namespace

std::unique_ptr<Term> make_joint_limits(const TermContext& context) {
  return std::make_unique<JointLimits>(context);
}

}  // namespace legwright
