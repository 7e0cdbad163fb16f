// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimizer/motion/cycle_target.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Style of the pose, the "desired poses" that the paper puts before its eqs (10): a joint has the
/// angle that the task wants over the cycle. Residual √w (q_a − angle) [rad] at every knot, for the
/// joints that have a target; w is the target's own weight.
class StyleJoint final : public LinearTerm {
 public:
  explicit StyleJoint(const TermContext& context) {
    const Layout& layout = context.layout;
    for (int i = 0; i <= layout.knot_count(); ++i)
      for (int a = 0; a < layout.joint_count(); ++a) {
        const CycleTarget* target = target_of(context.task.joint_angles, a);
        if (target == nullptr) continue;
        const double scale = std::sqrt(target->weight);
        const double angle = target->at(static_cast<double>(i) / layout.knot_count());
        add(i, -1, {{layout.pose(i) + 6 + a, times(scale, 1)}},
            Eigen::VectorXd::Constant(1, scale * angle));
        places_.push_back({context.morphology.links[a + 1].joint.name, 1.0 / scale});
      }
  }
  std::string_view name() const override { return "style_joint"; }
  ResidualUnit unit(int element, int) const override { return {place(element).size, "rad"}; }
  std::string subject(int element, int) const override { return place(element).joint; }

 private:
  struct Place {
    std::string joint;
    double size;  // of a residual of one [rad]
  };
  const Place& place(int element) const { return places_[static_cast<std::size_t>(element)]; }

  std::vector<Place> places_;  // by element
};

}  // namespace

std::unique_ptr<Term> make_style_joint(const TermContext& context) {
  return std::make_unique<StyleJoint>(context);
}

}  // namespace legwright
