// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/over_cycle.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (10), E_StyleEE: feet stay near the footprint under the moving COM, so that the plan keeps
/// off the edge of its support polygon, or where the task wants them from there over the cycle.
/// Residual (e_i − x_iᴰ − footprint(s))/length on the ground plane, at every knot; x_iᴰ is on the
/// wanted path, without style offsets. The footprint follows the hips of the design, to which it is
/// affine, unless the task gives it.
class StyleFoot final : public LinearTerm {
 public:
  explicit StyleFoot(const TermContext& context) : length_(context.length) {
    for (int i = 0; i <= context.layout.knot_count(); ++i)
      for (int j = 0; j < context.layout.foot_count(); ++j) add_foot(context, i, j);
  }
  std::string_view name() const override { return "style_foot"; }
  ResidualUnit unit(int, int) const override { return {length_, "m"}; }

 private:
  void add_foot(const TermContext& context, int knot, int foot) {
    const double scale = 1.0 / context.length, time = knot * context.task.gait.time_step();
    const Eigen::Matrix2d heading = context.path.heading_rotation(time);
    const Eigen::Vector2d place =
        context.path.position(time).head<2>() + heading * footprint(context, knot, foot);
    Eigen::VectorXd target = scale * place;
    std::vector<Block> blocks{{context.layout.foot(knot, foot), times(scale, 2)}};
    const auto index = static_cast<std::size_t>(foot);
    if (index < context.footprint_slopes.size() && !is_listed(context, foot)) {
      const Eigen::Matrix2Xd slopes = scale * heading * context.footprint_slopes[index];
      target -= slopes * context.space.initial();
      for (int k = 0; k < slopes.cols(); ++k)
        if (!slopes.col(k).isZero(0.0))
          blocks.push_back({context.layout.design(k), -slopes.col(k)});
    }
    add(knot, foot, blocks, target);
  }
  static bool is_listed(const TermContext& context, int foot) {
    const auto& targets = context.task.foot_targets;
    const auto index = static_cast<std::size_t>(foot);
    return index < targets.size() && !targets[index].empty();
  }
  static Eigen::Vector2d footprint(const TermContext& context, int knot, int foot) {
    const auto index = static_cast<std::size_t>(foot);
    if (!is_listed(context, foot)) return context.footprint[index];
    return over_cycle(context.task.foot_targets[index],
                      static_cast<double>(knot) / context.layout.knot_count());
  }

  double length_;
};

}  // namespace

std::unique_ptr<Term> make_style_foot(const TermContext& context) {
  return std::make_unique<StyleFoot>(context);
}

}  // namespace legwright
