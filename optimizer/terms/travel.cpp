// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Eq (9), E_Travel: over one cycle the COM moves by the wanted displacement.
/// Residual (x_T − turn·x_0 − travel)/length; turn is the cycle's change of heading, one when
/// walking straight.
class Travel final : public LinearTerm {
 public:
  explicit Travel(const TermContext& context) : length_(context.length) {
    const Layout& layout = context.layout;
    const double scale = 1.0 / context.length;
    add(0, -1,
        {{layout.com(layout.knot_count()), times(scale)},
         {layout.com(0), -scale * context.path.turn()}},
        scale * context.path.travel());
  }
  std::string_view name() const override { return "travel"; }
  ResidualUnit unit(int, int) const override { return {length_, "m"}; }

 private:
  double length_;
};

}  // namespace

std::unique_ptr<Term> make_travel(const TermContext& context) {
  return std::make_unique<Travel>(context);
}

}  // namespace legwright
