// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/factories.hpp"
#include "optimizer/terms/linear_term.hpp"

namespace legwright {
namespace {

/// Not in the paper, for outer objectives (weight zero unless asked for): what must be printed, the
/// volume of all parts whose mass follows from their density. Residual V/length³, counted as it is:
/// the term's value times length³ is the volume in cubic metres.
class PrintedVolume final : public LinearTerm {
 public:
  explicit PrintedVolume(const TermContext& context)
      : unit_(context.length * context.length * context.length) {
    add(0, -1, {{context.layout.printed_volume(), times(1.0, 1)}}, Eigen::VectorXd::Zero(1));
  }
  std::string_view name() const override { return "printed_volume"; }
  Penalty penalty() const override { return Penalty::linear; }
  ResidualUnit unit(int, int) const override { return {unit_, "m^3"}; }

 private:
  double unit_;
};

}  // namespace

std::unique_ptr<Term> make_printed_volume(const TermContext& context) {
  return std::make_unique<PrintedVolume>(context);
}

}  // namespace legwright
