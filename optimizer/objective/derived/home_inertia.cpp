// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/home_inertia.hpp"

#include "optimizer/objective/derived/design_quantity.hpp"
#include "optimizer/objective/derived/quantities.hpp"

namespace legwright {
namespace {

/// I of the paper's eq (13), six entries [kg m²].
class Inertia final : public DesignQuantity {
 public:
  Inertia(const DerivedSetting& setting, int slot)
      : Inertia(setting, slot, on_subtree(setting.morphology, setting.ancestry, 0).parameters) {}

 private:
  Inertia(const DerivedSetting& setting, int slot, const std::set<int>& parameters)
      : DesignQuantity(setting, slot, 6, {{}, parameters}),
        parameters_(parameters.begin(), parameters.end()) {}
  AtDesign at_design(const Morphology& morphology, const Eigen::VectorXd& s) const override {
    const HomeInertia inertia = home_inertia(morphology, parameters_, s);
    return {inertia.value, inertia.jacobian, inertia.hessian};
  }

  std::vector<int> parameters_;
};

}  // namespace

void list_home_inertia(int knot, DerivedList& out) {
  if (knot > 0) return;  // the same at all knots
  out.add<Inertia>(out.setting().layout.home_inertia(), 6);
}

}  // namespace legwright
