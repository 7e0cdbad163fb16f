// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (10), E_StyleEE: feet stay near the footprint under the moving COM, so that the plan keeps off the edge of its
/// support polygon. Residual (e_i − x_iᴰ − footprint)/length on the ground plane, at every knot.
class StyleFoot final : public LinearTerm {
 public:
  explicit StyleFoot(const TermContext& context) {
    const Layout& layout = context.layout;
    const double scale = 1.0 / context.length;
    for (int i = 0; i <= layout.knot_count(); ++i) {
      const double time = i * context.task.gait.time_step();
      const Eigen::Matrix2d heading =
          WantedPath::yaw_rotation(context.path.heading(time)).topLeftCorner<2, 2>();
      for (int j = 0; j < layout.foot_count(); ++j)
        add(i, j, {{layout.foot(i, j), times(scale, 2)}},
            scale * (context.path.position(time).head<2>() + heading * context.footprint[j]));
    }
  }
  std::string_view name() const override { return "style_foot"; }
};

}  // namespace

std::unique_ptr<Term> make_style_foot(const TermContext& context) {
  return std::make_unique<StyleFoot>(context);
}

}  // namespace legwright
