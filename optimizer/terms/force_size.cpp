// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Not in the paper: forces stay small; tiny weight, shares the load among stance feet and keeps
/// H regular. Residual f/weight at every stance knot.
class ForceSize final : public LinearTerm {
 public:
  explicit ForceSize(const TermContext& context) : weight_(context.weight) {
    const Layout& layout = context.layout;
    for (int i = 0; i < layout.knot_count(); ++i)
      for (int j = 0; j < layout.foot_count(); ++j)
        if (layout.force(i, j) >= 0)
          add(i, j, {{layout.force(i, j), times(1.0 / context.weight)}}, Eigen::Vector3d::Zero());
  }
  std::string_view name() const override { return "force_size"; }
  ResidualUnit unit(int, int) const override { return {weight_, "N"}; }

 private:
  double weight_;
};

}  // namespace

std::unique_ptr<Term> make_force_size(const TermContext& context) {
  return std::make_unique<ForceSize>(context);
}

}  // namespace legwright
