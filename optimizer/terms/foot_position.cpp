// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (12), second half: φ_EE(q_i)ʲ = e_iʲ. Residual (φ_EE(q_i, s)ʲ − e_iʲ)/length at every knot
/// and foot.
class FootPosition final : public LinearTerm {
 public:
  explicit FootPosition(const TermContext& context) : length_(context.length) {
    const Layout& layout = context.layout;
    const double scale = 1.0 / context.length;
    for (int i = 0; i <= layout.knot_count(); ++i)
      for (int j = 0; j < layout.foot_count(); ++j)
        add(i, j, {{layout.foot_from_pose(i, j), times(scale)}, {layout.foot(i, j), times(-scale)}},
            Eigen::Vector3d::Zero());
  }
  std::string_view name() const override { return "foot_position"; }
  ResidualUnit unit(int, int) const override { return {length_, "m"}; }

 private:
  double length_;
};

}  // namespace

std::unique_ptr<Term> make_foot_position(const TermContext& context) {
  return std::make_unique<FootPosition>(context);
}

}  // namespace legwright
