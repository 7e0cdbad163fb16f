// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/pose_gradient.hpp"
#include "optimizer/objective/derived/quantities.hpp"
#include "optimizer/objective/derived/vector_quantity.hpp"

namespace legwright {
namespace {

/// Where the hinge of a link is anchored [m, world]; its own joint does not move it.
class Anchor final : public PoseQuantity {
 public:
  Anchor(const DerivedSetting& setting, int slot, int knot, int link)
      : PoseQuantity(setting, slot, knot,
                     on_point(setting.morphology, setting.morphology.links[link].parent,
                              setting.morphology.links[link].origin)),
        link_(link) {}

 private:
  Eigen::Vector3d place(const DerivedInput& input) const override {
    return pose(input).origin(link_);
  }
  void derive(const DerivedInput& input, PointDerivatives& out) const override {
    anchor_from_pose(input.ancestry, pose(input), link_, columns(), out);
  }
  void add_pose_gradient(const DerivedInput& input, const Eigen::Vector3d& multiplier,
                         double* gradient) const override {
    // Without the design only what moves the parent moves it.
    add_point_gradient(input.morphology, pose(input), input.morphology.links[link_].parent,
                       place(input), multiplier, gradient);
  }

  int link_;
};

}  // namespace

void list_anchors(int knot, DerivedList& out) {
  const Layout& layout = out.setting().layout;
  for (int link = 1; link <= layout.joint_count(); ++link)
    out.add<Anchor>(layout.link_anchor(knot, link), 3, knot, link);
}

}  // namespace legwright
