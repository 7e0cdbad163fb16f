// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (10), E_StyleCOM: the COM follows the wanted path at the wanted height.
/// Residual (x_i − x_iᴰ)/length at every knot.
class StyleCom final : public LinearTerm {
 public:
  explicit StyleCom(const TermContext& context) {
    const Layout& layout = context.layout;
    const double scale = 1.0 / context.length;
    for (int i = 0; i <= layout.knot_count(); ++i) {
      Eigen::Vector3d target = context.path.position(i * context.task.gait.time_step());
      target.z() = context.com_height;
      add(i, -1, {{layout.com(i), times(scale)}}, scale * target);
    }
  }
  std::string_view name() const override { return "style_com"; }
};

}  // namespace

std::unique_ptr<Term> make_style_com(const TermContext& context) {
  return std::make_unique<StyleCom>(context);
}

}  // namespace legwright
