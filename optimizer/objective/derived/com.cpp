// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/pose_gradient.hpp"
#include "optimizer/objective/derived/quantities.hpp"
#include "optimizer/objective/derived/vector_quantity.hpp"

namespace legwright {
namespace {

/// φ_COM(q_i, s) of eq (12): the centre of mass of a pose [m, world].
class Com final : public PoseQuantity {
 public:
  Com(const DerivedSetting& setting, int slot, int knot)
      : PoseQuantity(setting, slot, knot, on_subtree(setting.morphology, setting.ancestry, 0)) {}

 private:
  static double scale(const DerivedInput& input) { return 1.0 / input.robot.geometry.total_mass; }
  Eigen::Vector3d place(const DerivedInput& input) const override {
    return pose(input).first_moment(0) / input.robot.geometry.total_mass;
  }
  void derive(const DerivedInput& input, PointDerivatives& out) const override {
    com_from_pose(input.robot.geometry, input.ancestry, pose(input), columns(), out);
  }
  void add_pose_gradient(const DerivedInput& input, const Eigen::Vector3d& multiplier,
                         double* gradient) const override {
    add_first_moment_gradient(input.robot.geometry, input.ancestry, pose(input), 0, scale(input),
                              multiplier, gradient);
  }
  bool add_motion_jacobian(const DerivedInput& input, Eigen::MatrixXd& jacobian) const override {
    add_first_moment_jacobian(input.robot.geometry, input.ancestry, pose(input), 0, scale(input),
                              columns(), jacobian);
    return true;
  }
  bool add_loads(const DerivedInput& input, const State&, const double* multiplier,
                 MotionLoads& loads) const override {
    own(loads).add_first_moment(input.robot.geometry, input.ancestry, pose(input), 0,
                                scale(input) * scalars(multiplier));
    return true;
  }
};

}  // namespace

void list_com(int knot, DerivedList& out) {
  out.add<Com>(out.setting().layout.com_from_pose(knot), 3, knot);
}

}  // namespace legwright
