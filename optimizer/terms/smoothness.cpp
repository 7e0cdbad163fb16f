// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/margins.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (11), E_Smooth: second differences of root rotation and joint angles, per time:
/// (q_{i−1} − 2 q_i + q_{i+1})·τ²/h², τ² = 4e-3 s² for legs of 21 cm and in proportion to the leg,
/// so that the weight depends neither on the number of knots nor on the size of the robot. Wraps
/// from knot 0 to knot T − 1 one cycle earlier. The root's position is left to style_com.
class Smoothness final : public LinearTerm {
 public:
  explicit Smoothness(const TermContext& context) {
    const Layout& layout = context.layout;
    const double h = context.task.gait.time_step(),
                 leg = standing_leg(context.morphology, context.space.initial()),
                 scale = smoothness_time_squared(leg) / (h * h);
    const int size = layout.pose_size() - 3;
    for (int i = 0; i < layout.knot_count(); ++i) {
      const int before = i > 0 ? i - 1 : layout.knot_count() - 1;
      Eigen::VectorXd target = Eigen::VectorXd::Zero(size);
      if (i == 0) target[2] = scale * context.path.turn_angle();  // yaw one cycle earlier
      add(i, -1,
          {{layout.pose(before) + 3, times(scale, size)},
           {layout.pose(i) + 3, times(-2 * scale, size)},
           {layout.pose(i + 1) + 3, times(scale, size)}},
          target);
    }
  }
  std::string_view name() const override { return "smoothness"; }
  ResidualUnit unit(int, int) const override { return {1.0, "rad"}; }
};

}  // namespace

std::unique_ptr<Term> make_smoothness(const TermContext& context) {
  return std::make_unique<Smoothness>(context);
}

}  // namespace legwright
