// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/pose_gradient.hpp"
#include "optimizer/objective/derived/quantities.hpp"
#include "optimizer/objective/derived/vector_quantity.hpp"

namespace legwright {
namespace {

/// An end of a capsule that collides, for (16) [m, world]: 2 k is `from` of capsule k, 2 k + 1 is
/// `to`.
class CapsuleEnd final : public PoseQuantity {
 public:
  CapsuleEnd(const DerivedSetting& setting, int slot, int knot, int end)
      : PoseQuantity(setting, slot, knot, on_end(setting.morphology, end)), end_(end) {}

 private:
  static Dependence on_end(const Morphology& morphology, int end) {
    const Capsule& capsule = morphology.capsules[end / 2];
    return on_point(morphology, capsule.link, end % 2 == 0 ? capsule.from : capsule.to);
  }
  Eigen::Vector3d place(const DerivedInput& input) const override {
    return capsule_end_place(input.morphology, input.robot.geometry, pose(input), end_);
  }
  void derive(const DerivedInput& input, PointDerivatives& out) const override {
    capsule_end_from_pose(input.morphology, input.robot.geometry, input.ancestry, pose(input), end_,
                          columns(), out);
  }
  void add_pose_gradient(const DerivedInput& input, const Eigen::Vector3d& multiplier,
                         double* gradient) const override {
    add_point_gradient(input.morphology, pose(input), input.morphology.capsules[end_ / 2].link,
                       place(input), multiplier, gradient);
  }

  int end_;
};

}  // namespace

void list_capsule_ends(int knot, DerivedList& out) {
  const Layout& layout = out.setting().layout;
  if (knot == layout.knot_count()) return;
  const int count = 2 * static_cast<int>(out.setting().morphology.capsules.size());
  for (int end = 0; end < count; ++end)
    out.add<CapsuleEnd>(layout.capsule_end(knot, end / 2, end % 2), 3, knot, end);
}

}  // namespace legwright
