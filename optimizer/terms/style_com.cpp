// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/over_cycle.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (10), E_StyleCOM: the COM follows the wanted path at the wanted height, or the height and the
/// offsets from the path, in the heading frame, that the task gives over the cycle. Residual
/// (x_i − x_iᴰ)/length at every knot.
class StyleCom final : public LinearTerm {
 public:
  explicit StyleCom(const TermContext& context) : length_(context.length) {
    const Layout& layout = context.layout;
    const double scale = 1.0 / context.length;
    for (int i = 0; i <= layout.knot_count(); ++i)
      add(i, -1, {{layout.com(i), times(scale)}}, scale * target(context, i));
  }
  std::string_view name() const override { return "style_com"; }
  ResidualUnit unit(int, int) const override { return {length_, "m"}; }

 private:
  static Eigen::Vector3d target(const TermContext& context, int knot) {
    const Task& task = context.task;
    const double phase = static_cast<double>(knot) / context.layout.knot_count();
    const double time = knot * task.gait.time_step();
    Eigen::Vector3d target = context.path.position(time);
    if (!task.com_path.empty())
      target.head<2>() += context.path.heading_rotation(time) * over_cycle(task.com_path, phase);
    target.z() =
        task.com_heights.empty() ? context.com_height : over_cycle(task.com_heights, phase);
    return target;
  }

  double length_;
};

}  // namespace

std::unique_ptr<Term> make_style_com(const TermContext& context) {
  return std::make_unique<StyleCom>(context);
}

}  // namespace legwright
