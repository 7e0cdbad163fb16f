// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (12), first half: φ_COM(q_i) = x_i. Residual (φ_COM(q_i, s) − x_i)/length at every knot.
/// Its weight is high: a mismatch δ enters the accelerations as 4δ/h².
class ComPosition final : public LinearTerm {
 public:
  explicit ComPosition(const TermContext& context) : length_(context.length) {
    const Layout& layout = context.layout;
    const double scale = 1.0 / context.length;
    for (int i = 0; i <= layout.knot_count(); ++i)
      add(i, -1, {{layout.com_from_pose(i), times(scale)}, {layout.com(i), times(-scale)}},
          Eigen::Vector3d::Zero());
  }
  std::string_view name() const override { return "com_position"; }
  ResidualUnit unit(int, int) const override { return {length_, "m"}; }

 private:
  double length_;
};

}  // namespace

std::unique_ptr<Term> make_com_position(const TermContext& context) {
  return std::make_unique<ComPosition>(context);
}

}  // namespace legwright
