// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/pose_gradient.hpp"
#include "optimizer/objective/derived/quantities.hpp"
#include "optimizer/objective/derived/vector_quantity.hpp"

namespace legwright {
namespace {

/// Σ m p × p′ over all point masses from one pose to the next, for the angular momentum of eq (13)
/// [kg m²]. Knot T stands for the pair that wraps: knot T − 1, moved back by one cycle, to knot 0.
class SweptMomentum final : public VectorQuantity<PairDerivatives> {
 public:
  SweptMomentum(const DerivedSetting& setting, int slot, int knot)
      : VectorQuantity(setting, slot, knots(setting.layout, knot),
                       on_subtree(setting.morphology, setting.ancestry, 0)),
        pair_(static_cast<std::size_t>(knot)) {
    const bool wraps = knot == setting.layout.knot_count();
    first_ = wraps ? pair_ + 1 : pair_;
    second_ = wraps ? 0 : pair_ + 1;
  }
  bool needs_moments() const override { return true; }
  bool add_motion_gradient(const DerivedInput& input, const double* multiplier,
                           double* gradient) const override {
    add_swept_momentum_gradient(input.ancestry, input.robot.moments[pair_], 0,
                                input.robot.poses[first_], input.robot.poses[second_],
                                Eigen::Map<const Eigen::Vector3d>(multiplier),
                                gradient + pose_slot(0), gradient + pose_slot(1));
    return true;
  }
  bool add_loads(const DerivedInput& input, const State&, const double* multiplier,
                 MotionLoads& loads) const override {
    loads.pairs[pair_].add_swept_momentum(input.robot.geometry, input.ancestry, 0,
                                          input.robot.moments[pair_], input.robot.poses[first_],
                                          input.robot.poses[second_], scalars(multiplier),
                                          loads.poses[first_], loads.poses[second_]);
    return true;
  }

 private:
  static std::vector<int> knots(const Layout& layout, int knot) {
    if (knot == layout.knot_count()) return {knot - 1, 0};
    return {knot, knot + 1};
  }
  Eigen::Vector3d place(const DerivedInput& input) const override {
    return input.robot.moments[pair_].swept(0);
  }
  void derive(const DerivedInput& input, PairDerivatives& out) const override {
    out.compute_swept_momentum(input.robot.geometry, input.ancestry, 0, input.robot.moments[pair_],
                               input.robot.poses[first_], input.robot.poses[second_], columns(0),
                               columns(1));
  }
  bool add_motion_jacobian(const DerivedInput& input, Eigen::MatrixXd& jacobian) const override {
    add_swept_momentum_jacobian(input.ancestry, input.robot.moments[pair_], 0,
                                input.robot.poses[first_], input.robot.poses[second_], columns(0),
                                columns(1), jacobian);
    return true;
  }

  std::size_t pair_, first_, second_;  // entries of RobotAtPoint
};

}  // namespace

void list_swept_momentum(int knot, DerivedList& out) {
  if (knot < out.setting().layout.knot_count())
    out.add<SweptMomentum>(out.setting().layout.swept_momentum(knot), 3, knot);
}

void list_wrapping_momentum(int knot, DerivedList& out) {
  if (knot == out.setting().layout.knot_count())
    out.add<SweptMomentum>(out.setting().layout.wrapping_momentum(), 3, knot);
}

}  // namespace legwright
