// SPDX-License-Identifier: Apache-2.0
#include "optimizer/motion/over_cycle.hpp"
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (10), E_StyleEE: feet stay near the footprint under the moving COM, so that the plan keeps
/// off the edge of its support polygon, or where the task wants them from there over the cycle.
/// Residual (e_i − x_iᴰ − footprint)/length on the ground plane, at every knot; x_iᴰ is on the
/// wanted path, without style offsets.
class StyleFoot final : public LinearTerm {
 public:
  explicit StyleFoot(const TermContext& context) : length_(context.length) {
    const Layout& layout = context.layout;
    const double scale = 1.0 / context.length;
    for (int i = 0; i <= layout.knot_count(); ++i) {
      const double time = i * context.task.gait.time_step();
      const Eigen::Vector2d place = context.path.position(time).head<2>();
      const Eigen::Matrix2d heading = context.path.heading_rotation(time);
      for (int j = 0; j < layout.foot_count(); ++j)
        add(i, j, {{layout.foot(i, j), times(scale, 2)}},
            scale * (place + heading * footprint(context, i, j)));
    }
  }
  std::string_view name() const override { return "style_foot"; }
  ResidualUnit unit(int, int) const override { return {length_, "m"}; }

 private:
  static Eigen::Vector2d footprint(const TermContext& context, int knot, int foot) {
    const auto& targets = context.task.foot_targets;
    const auto place = static_cast<std::size_t>(foot);
    if (place >= targets.size() || targets[place].empty()) return context.footprint[place];
    return over_cycle(targets[place], static_cast<double>(knot) / context.layout.knot_count());
  }

  double length_;
};

}  // namespace

std::unique_ptr<Term> make_style_foot(const TermContext& context) {
  return std::make_unique<StyleFoot>(context);
}

}  // namespace legwright
