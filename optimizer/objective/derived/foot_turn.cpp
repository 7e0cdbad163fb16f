// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/pose_gradient.hpp"
#include "optimizer/objective/derived/quantities.hpp"
#include "optimizer/objective/derived/vector_quantity.hpp"

namespace legwright {
namespace {

/// Rotation vector of a foot's link from a knot to the next, to second order, for rolling in eq
/// (14) [rad, world].
class FootTurn final : public VectorQuantity<PairDerivatives> {
 public:
  FootTurn(const DerivedSetting& setting, int slot, int knot, int foot)
      : VectorQuantity(setting, slot, {knot, knot + 1},
                       on_point(setting.morphology, setting.morphology.feet[foot].link,
                                setting.morphology.feet[foot].position)),
        knot_(static_cast<std::size_t>(knot)),
        foot_(foot) {}

  bool add_motion_gradient(const DerivedInput& input, const double* multiplier,
                           double* gradient) const override {
    add_foot_turn_gradient(input.morphology, foot_, input.robot.poses[knot_],
                           input.robot.poses[knot_ + 1],
                           Eigen::Map<const Eigen::Vector3d>(multiplier), gradient + pose_slot(0),
                           gradient + pose_slot(1));
    return true;
  }
  bool add_loads(const DerivedInput& input, const State&, const double* multiplier,
                 MotionLoads& loads) const override {
    loads.pairs[knot_].add_foot_turn(input.morphology, foot_, input.robot.poses[knot_],
                                     input.robot.poses[knot_ + 1], scalars(multiplier),
                                     loads.poses[knot_], loads.poses[knot_ + 1]);
    return true;
  }

 private:
  Eigen::Vector3d place(const DerivedInput& input) const override {
    return PairDerivatives::foot_turn(input.morphology, foot_, input.robot.poses[knot_],
                                      input.robot.poses[knot_ + 1]);
  }
  void derive(const DerivedInput& input, PairDerivatives& out) const override {
    out.compute_foot_turn(input.morphology, input.ancestry, foot_, input.robot.poses[knot_],
                          input.robot.poses[knot_ + 1], columns(0), columns(1));
  }

  bool add_motion_jacobian(const DerivedInput& input, Eigen::MatrixXd& jacobian) const override {
    add_foot_turn_jacobian(input.morphology, foot_, input.robot.poses[knot_],
                           input.robot.poses[knot_ + 1], columns(0), columns(1), jacobian);
    return true;
  }

  std::size_t knot_;
  int foot_;
};

}  // namespace

void list_foot_turns(int knot, DerivedList& out) {
  const Layout& layout = out.setting().layout;
  if (knot == layout.knot_count()) return;
  for (int j = 0; j < layout.foot_count(); ++j)
    out.add<FootTurn>(layout.foot_turn(knot, j), 3, knot, j);
}

}  // namespace legwright
