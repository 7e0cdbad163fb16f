// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/actuator_length.hpp"
#include "optimizer/objective/derived/design_quantity.hpp"
#include "optimizer/objective/derived/quantities.hpp"

namespace legwright {
namespace {

/// A, B, C of a linear actuator's length, L² = A + B cos q + C sin q [leg length²].
class Shape final : public DesignQuantity {
 public:
  Shape(const DerivedSetting& setting, int slot, int actuator)
      : DesignQuantity(setting, slot, 3, on_actuator(setting.morphology, actuator)),
        actuator_(actuator) {}

 private:
  static Dependence on_actuator(const Morphology& morphology, int actuator) {
    const std::vector<int> parameters =
        actuator_parameters(morphology, morphology.linear_actuators[actuator]);
    return {{}, {parameters.begin(), parameters.end()}};
  }
  AtDesign at_design(const Morphology& morphology, const Eigen::VectorXd& s) const override {
    const ActuatorShape shape =
        actuator_shape(morphology, morphology.linear_actuators[actuator_], s);
    return {shape.value, shape.jacobian.transpose(), shape.hessian};
  }

  int actuator_;
};

}  // namespace

void list_actuator_shapes(int knot, DerivedList& out) {
  if (knot > 0) return;  // the same at all knots
  const auto count = static_cast<int>(out.setting().morphology.linear_actuators.size());
  for (int k = 0; k < count; ++k) out.add<Shape>(out.setting().layout.actuator_shape(k), 3, k);
}

}  // namespace legwright
