// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/pose_gradient.hpp"
#include "optimizer/objective/derived/quantities.hpp"
#include "optimizer/objective/derived/vector_quantity.hpp"

namespace legwright {
namespace {

/// φ_EE(q_i, s)ʲ of eq (12): the centre of a foot [m, world].
class FootCentre final : public PoseQuantity {
 public:
  FootCentre(const DerivedSetting& setting, int slot, int knot, int foot)
      : PoseQuantity(setting, slot, knot,
                     on_point(setting.morphology, setting.morphology.feet[foot].link,
                              setting.morphology.feet[foot].position)),
        foot_(foot) {}

 private:
  Eigen::Vector3d place(const DerivedInput& input) const override {
    return foot_place(input.morphology, input.robot.geometry, pose(input), foot_);
  }
  void derive(const DerivedInput& input, PointDerivatives& out) const override {
    foot_from_pose(input.morphology, input.robot.geometry, input.ancestry, pose(input), foot_,
                   columns(), out);
  }
  void add_pose_gradient(const DerivedInput& input, const Eigen::Vector3d& multiplier,
                         double* gradient) const override {
    add_point_gradient(input.morphology, pose(input), input.morphology.feet[foot_].link,
                       place(input), multiplier, gradient);
  }

  bool add_motion_jacobian(const DerivedInput& input, Eigen::MatrixXd& jacobian) const override {
    add_point_jacobian(input.morphology, pose(input), input.morphology.feet[foot_].link,
                       place(input), columns(), jacobian);
    return true;
  }
  bool add_loads(const DerivedInput& input, const State&, const double* multiplier,
                 MotionLoads& loads) const override {
    own(loads).add_point(input.morphology, input.morphology.feet[foot_].link, scalars(place(input)),
                         scalars(multiplier));
    return true;
  }

  int foot_;
};

}  // namespace

void list_feet(int knot, DerivedList& out) {
  const Layout& layout = out.setting().layout;
  for (int j = 0; j < layout.foot_count(); ++j)
    out.add<FootCentre>(layout.foot_from_pose(knot, j), 3, knot, j);
}

}  // namespace legwright
