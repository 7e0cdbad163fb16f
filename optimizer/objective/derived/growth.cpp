// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/growth.hpp"

#include "optimizer/objective/derived/design_quantity.hpp"
#include "optimizer/objective/derived/quantities.hpp"

namespace legwright {
namespace {

/// A sum over the point masses that grow with the design, in a unit that makes it a plain number.
class Sum final : public DesignQuantity {
 public:
  Sum(const DerivedSetting& setting, int slot, Amount amount, double unit)
      : DesignQuantity(setting, slot, 1, on_growth(setting.morphology)),
        amount_(amount),
        unit_(unit) {}

 private:
  static Dependence on_growth(const Morphology& morphology) {
    const std::vector<int> parameters = growth_parameters(morphology);
    return {{}, {parameters.begin(), parameters.end()}};
  }
  AtDesign at_design(const Morphology& morphology, const Eigen::VectorXd& s) const override {
    const GrowthSum sum = growth_sum(morphology, amount_, s);
    return {Eigen::VectorXd::Constant(1, sum.value / unit_),
            sum.gradient / unit_,
            {sum.hessian / unit_}};
  }

  Amount amount_;
  double unit_;
};

}  // namespace

void list_mass_share(int knot, DerivedList& out) {
  if (knot > 0) return;  // the same at all knots
  const DerivedSetting& setting = out.setting();
  out.add<Sum>(setting.layout.mass_share(), 1, Amount::mass, setting.morphology.total_mass());
}

void list_printed_volume(int knot, DerivedList& out) {
  if (knot > 0) return;
  const DerivedSetting& setting = out.setting();
  const double leg = setting.morphology.leg_length;
  out.add<Sum>(setting.layout.printed_volume(), 1, Amount::printed_volume, leg * leg * leg);
}

}  // namespace legwright
