// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/pose_gradient.hpp"
#include "optimizer/objective/derived/quantities.hpp"
#include "optimizer/objective/derived/vector_quantity.hpp"

namespace legwright {
namespace {

/// Where a flat foot's sole points ahead (0) or beside (1), a unit vector in the world.
class SoleDirection final : public PoseQuantity {
 public:
  SoleDirection(const DerivedSetting& setting, int slot, int knot, int foot, int which)
      : PoseQuantity(setting, slot, knot,
                     on_chain(setting.morphology, setting.morphology.feet[foot].link)),
        link_(setting.morphology.feet[foot].link),
        own_(which == 0 ? setting.morphology.feet[foot].sole->ahead
                        : setting.morphology.feet[foot].sole->beside) {}

 private:
  Eigen::Vector3d place(const DerivedInput& input) const override {
    return pose(input).rotation(link_) * own_;
  }
  void derive(const DerivedInput& input, PointDerivatives& out) const override {
    direction_from_pose(input.ancestry, pose(input), link_, own_, columns(), out);
  }
  void add_pose_gradient(const DerivedInput& input, const Eigen::Vector3d& multiplier,
                         double* gradient) const override {
    add_direction_gradient(input.morphology, pose(input), link_, place(input), multiplier,
                           gradient);
  }
  bool add_motion_jacobian(const DerivedInput& input, Eigen::MatrixXd& jacobian) const override {
    add_direction_jacobian(input.morphology, pose(input), link_, place(input), columns(), jacobian);
    return true;
  }
  bool add_loads(const DerivedInput& input, const State&, const double* multiplier,
                 MotionLoads& loads) const override {
    own(loads).add_direction(input.morphology, link_, scalars(place(input)), scalars(multiplier));
    return true;
  }

  int link_;
  Eigen::Vector3d own_;  // in the frame of the link
};

}  // namespace

void list_sole_directions(int knot, DerivedList& out) {
  const DerivedSetting& setting = out.setting();
  for (int j = 0; j < setting.layout.foot_count(); ++j)
    for (int which = 0; which < 2 && setting.morphology.feet[j].sole; ++which)
      out.add<SoleDirection>(setting.layout.sole_direction(knot, j, which), 3, knot, j, which);
}

}  // namespace legwright
