// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/pose_gradient.hpp"
#include "optimizer/objective/derived/quantities.hpp"
#include "optimizer/objective/derived/vector_quantity.hpp"

namespace legwright {
namespace {

/// A point that is fixed to a link, seen from the trunk [m, trunk frame]. How far parts of one
/// robot are apart, (16), is the same wherever its trunk is, so these know nothing of the trunk's
/// coordinates, and a point of the trunk itself of no coordinate at all.
class TrunkPoint : public PoseQuantity {
 protected:
  TrunkPoint(const DerivedSetting& setting, int slot, int knot, int link, const AffineVector& own)
      : PoseQuantity(setting, slot, knot, on_point_of_trunk(setting.morphology, link, own)),
        link_(link) {}

 private:
  Eigen::Vector3d place(const DerivedInput& input) const final {
    return place_from_trunk(pose(input), link_, at_design(input.robot.geometry));
  }
  void derive(const DerivedInput& input, PointDerivatives& out) const final {
    point_from_trunk(input.morphology, input.ancestry, pose(input), link_, place(input),
                     own(input.morphology), columns(), out);
  }
  void add_pose_gradient(const DerivedInput& input, const Eigen::Vector3d& multiplier,
                         double* gradient) const final {
    add_trunk_point_gradient(input.morphology, pose(input), link_, place(input), multiplier,
                             gradient);
  }
  /// In the frame of the link.
  virtual const AffineVector& own(const Morphology& morphology) const = 0;
  virtual Eigen::Vector3d at_design(const GeometryAtDesign& geometry) const = 0;

  int link_;
};

/// Where the hinge of a link is anchored in its parent.
class Anchor final : public TrunkPoint {
 public:
  Anchor(const DerivedSetting& setting, int slot, int knot, int link)
      : TrunkPoint(setting, slot, knot, setting.morphology.links[link].parent,
                   setting.morphology.links[link].origin),
        of_(link) {}

 private:
  const AffineVector& own(const Morphology& morphology) const override {
    return morphology.links[of_].origin;
  }
  Eigen::Vector3d at_design(const GeometryAtDesign& geometry) const override {
    return geometry.links[of_].origin;
  }
  int of_;
};

/// The centre of a foot.
class LimbEnd final : public TrunkPoint {
 public:
  LimbEnd(const DerivedSetting& setting, int slot, int knot, int foot)
      : TrunkPoint(setting, slot, knot, setting.morphology.feet[foot].link,
                   setting.morphology.feet[foot].position),
        foot_(foot) {}

 private:
  const AffineVector& own(const Morphology& morphology) const override {
    return morphology.feet[foot_].position;
  }
  Eigen::Vector3d at_design(const GeometryAtDesign& geometry) const override {
    return geometry.feet[foot_];
  }
  int foot_;
};

/// An end of a capsule that collides: 2 k is `from` of capsule k, 2 k + 1 is `to`.
class CapsuleEnd final : public TrunkPoint {
 public:
  CapsuleEnd(const DerivedSetting& setting, int slot, int knot, int end)
      : TrunkPoint(setting, slot, knot, setting.morphology.capsules[end / 2].link,
                   end_of(setting.morphology, end)),
        end_(end) {}

 private:
  static const AffineVector& end_of(const Morphology& morphology, int end) {
    const Capsule& capsule = morphology.capsules[end / 2];
    return end % 2 == 0 ? capsule.from : capsule.to;
  }
  const AffineVector& own(const Morphology& morphology) const override {
    return end_of(morphology, end_);
  }
  Eigen::Vector3d at_design(const GeometryAtDesign& geometry) const override {
    return geometry.capsule_ends[end_];
  }
  int end_;
};

}  // namespace

void list_trunk_points(int knot, DerivedList& out) {
  const Layout& layout = out.setting().layout;
  if (knot == layout.knot_count()) return;
  for (int link = 1; link <= layout.joint_count(); ++link)
    out.add<Anchor>(layout.link_anchor(knot, link), 3, knot, link);
  for (int foot = 0; foot < layout.foot_count(); ++foot)
    out.add<LimbEnd>(layout.limb_end(knot, foot), 3, knot, foot);
  const int count = 2 * static_cast<int>(out.setting().morphology.capsules.size());
  for (int end = 0; end < count; ++end)
    out.add<CapsuleEnd>(layout.capsule_end(knot, end / 2, end % 2), 3, knot, end);
}

}  // namespace legwright
