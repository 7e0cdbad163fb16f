// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "optimizer/objective/derived/quantity.hpp"

namespace legwright {

/// A derived quantity that depends on the design alone: worked out once for each s, with all
/// derivatives.
class DesignQuantity : public DerivedQuantity {
 public:
  /// y and its derivatives in the parameters of the Dependence, rising.
  struct AtDesign {
    Eigen::VectorXd value;
    Eigen::MatrixXd jacobian;              // parameters × size
    std::vector<Eigen::MatrixXd> hessian;  // by entry of y
  };

  std::unique_ptr<State> make_state() const final { return std::make_unique<Held>(); }
  void prepare_design(const Morphology& morphology, const Eigen::VectorXd& s,
                      State& state) const final {
    static_cast<Held&>(state).at = at_design(morphology, s);
  }
  void value(const DerivedInput&, State& state, Eigen::Ref<Eigen::VectorXd> y) const final {
    y = static_cast<Held&>(state).at.value;
  }
  void jacobian(const DerivedInput&, State& state, Eigen::MatrixXd& jacobian) const final {
    jacobian = static_cast<Held&>(state).at.jacobian;
  }
  bool add_motion_gradient(const DerivedInput&, const double*, double*) const final { return true; }
  void curvature(const Ancestry&, const State& state, const double* multiplier,
                 Eigen::MatrixXd& hessian) const final {
    const AtDesign& at = static_cast<const Held&>(state).at;
    hessian = multiplier[0] * at.hessian[0];
    for (std::size_t k = 1; k < at.hessian.size(); ++k) hessian += multiplier[k] * at.hessian[k];
  }

 protected:
  DesignQuantity(const DerivedSetting& setting, int slot, int size, const Dependence& on)
      : DerivedQuantity(setting, slot, size, {}, on) {}

 private:
  struct Held : State {
    AtDesign at;
  };
  virtual AtDesign at_design(const Morphology& morphology, const Eigen::VectorXd& s) const = 0;
};

}  // namespace legwright
