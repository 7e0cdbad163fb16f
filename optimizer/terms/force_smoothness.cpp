// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Not in the paper: forces change slowly; left alone, fast plans hop. Residual
/// (f_{i+1} − f_i)/weight between neighbouring stance knots.
class ForceSmoothness final : public LinearTerm {
 public:
  explicit ForceSmoothness(const TermContext& context) : weight_(context.weight) {
    const Layout& layout = context.layout;
    const double scale = 1.0 / context.weight;
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int j = 0; j < layout.foot_count(); ++j)
        if (layout.force(i, j) >= 0 && layout.force(i + 1, j) >= 0)
          add(i, j, {{layout.force(i + 1, j), times(scale)}, {layout.force(i, j), times(-scale)}},
              Eigen::Vector3d::Zero());
  }
  std::string_view name() const override { return "force_smoothness"; }
  ResidualUnit unit(int, int) const override { return {weight_, "N"}; }

 private:
  double weight_;
};

}  // namespace

std::unique_ptr<Term> make_force_smoothness(const TermContext& context) {
  return std::make_unique<ForceSmoothness>(context);
}

}  // namespace legwright
