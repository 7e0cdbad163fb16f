// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/tray_mass.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mjcf/assembly/limb_hulls.hpp"

namespace legwright {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// [m], as `legwright parts` has them by its --fit and twice its --wall.
constexpr double kFitOfTray = 0.15e-3, kWallOfTray = 2.4e-3;
constexpr double kPlate = 4.0 * kWallOfTray;     // lower trunks are not hollow
constexpr double kLowOverFloor = 15e-3;          // cradles that are higher stand on nothing
constexpr double kRibAt = 0.2;                   // of the longer side of a part
constexpr double kAside = 0.8e-3, kUp = 0.4e-3;  // between samples: a third and a sixth of a wall
constexpr double kSampledMore = 1.03;            // than samples tell
constexpr double kGramsOfTray = 1e3;  // in a kilogram, to the next of which it is rounded

/// A shape of a module on the trunk, in the trunk's frame.
struct TrayShape {
  OutlineShape::Type type;
  Vector3d half;
  Isometry3d to_shape;  // shape ← trunk

  bool has(const Vector3d& point, double grown) const {
    const Vector3d at = to_shape * point;
    if (type == OutlineShape::Type::sphere) return at.norm() <= half.x() + grown;
    if (type == OutlineShape::Type::box)
      return (at.cwiseAbs().array() <= half.array() + grown).all();
    return std::hypot(at.x(), at.y()) <= half.x() + grown && std::abs(at.z()) <= half.z() + grown;
  }
};

/// What stands on the trunk, with its box.
struct TrayRider {
  bool is_servo = false;
  std::vector<TrayShape> shapes;
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;

  TrayRider(const Module& module, const Isometry3d& pose, bool mirrored)
      : is_servo(module.kind == ModuleKind::servo) {
    for (const OutlineShape& shape : module.outline) {
      Isometry3d at = pose * shape.pose();
      if (mirrored) {  // the shapes are their own mirror images
        at.translation().y() *= -1.0;
        const Vector3d flip(1.0, -1.0, 1.0);
        at.linear() = flip.asDiagonal() * at.linear() * flip.asDiagonal();
      }
      const Vector3d half = shape.half(), reach = at.linear().cwiseAbs() * half;
      shapes.push_back({shape.type, half, at.inverse()});
      low = low.cwiseMin(at.translation() - reach);
      high = high.cwiseMax(at.translation() + reach);
    }
  }

  bool has(const Vector3d& point, double grown) const {
    return std::any_of(shapes.begin(), shapes.end(),
                       [&](const TrayShape& shape) { return shape.has(point, grown); });
  }
  bool is_over(const Vector3d& point, double grown) const {
    return point.x() >= low.x() - grown && point.x() <= high.x() + grown &&
           point.y() >= low.y() - grown && point.y() <= high.y() + grown;
  }
  /// In it, larger by the fit, or above it, from where it is put in.
  bool takes_away(const Vector3d& point) const {
    const double inside = std::min(point.z(), 0.5 * (low.z() + high.z()));
    return has(point, kFitOfTray) || has({point.x(), point.y(), inside}, kFitOfTray);
  }
  /// In its cradle, up to the rim, or in what it stands on, which rises from the trunk's box.
  bool holds(const Vector3d& point, double floor, double rim, bool is_over_box) const {
    const double grown = is_servo ? kFitOfTray + kWallOfTray : kFitOfTray, under = low.z() - grown;
    if (is_servo && has(point, grown)) return point.z() <= rim;
    if (!is_over_box || point.z() < floor || point.z() > under || !is_over(point, grown))
      return false;
    if (is_servo) return under - floor < kLowOverFloor;
    const bool along_x = high.x() - low.x() > high.y() - low.y();
    const Eigen::Index long_side = along_x ? 0 : 1;
    const double length = high[long_side] - low[long_side],
                 share = (point[long_side] - low[long_side]) / length;
    return std::min(std::abs(share - kRibAt), std::abs(share - 1.0 + kRibAt)) * length <=
           0.5 * kWallOfTray;
  }
};

std::vector<TrayRider> tray_riders(const Assembly& assembly, const Vector3d& scale) {
  std::vector<TrayRider> out;
  for (const AssemblyPart& part : assembly.parts) {
    const Vector3d place = scale.cwiseProduct(part.position);
    out.emplace_back(part.module, Isometry3d(Eigen::Translation3d(place)), false);
  }
  for (const PlacedLimb& limb : placed_limbs(assembly)) {
    const AssemblyJoint& first = limb.of->joints.front();
    if (first.is_linear()) continue;
    Isometry3d pose = servo_pose(first, towards_above(limb, 0));
    // In the axes of the limb as the file gives it, of which this may be the mirror image.
    pose.pretranslate(limb.vector(scale.cwiseProduct(limb.hip)));
    out.emplace_back(first.servo, pose, limb.mirrored);
  }
  return out;
}

}  // namespace

double tray_mass(const Assembly& assembly, const Vector3d& scale) {
  const ModuleExtent box = extent_of(assembly.trunk);
  const Vector3d middle = scale.cwiseProduct(box.middle), half = scale.cwiseProduct(box.half),
                 low = middle - half, high = middle + half;
  const bool is_hollow =
      assembly.trunk.outline.front().type == OutlineShape::Type::box && high.z() - low.z() > kPlate;
  const double floor = is_hollow ? low.z() + kWallOfTray : high.z();
  const std::vector<TrayRider> riders = tray_riders(assembly, scale);
  Vector3d from = low, to = high;
  for (const TrayRider& rider : riders) {
    const Vector3d around = Vector3d::Constant(kFitOfTray + kWallOfTray);
    from = from.cwiseMin(rider.low - around);
    to = to.cwiseMax(rider.high + around);
  }
  const auto is_in = [&](const Vector3d& point, double less) {
    return ((point - middle).cwiseAbs().array() <= half.array() - less).head<2>().all();
  };
  double top = high.z();  // of ribs, which rise to what stands above the rim
  for (const TrayRider& rider : riders)
    if (!rider.is_servo) top = std::max(top, rider.low.z());
  std::size_t count = 0;
  std::vector<const TrayRider*> near;
  for (double x = from.x() + 0.5 * kAside; x < to.x(); x += kAside)
    for (double y = from.y() + 0.5 * kAside; y < to.y(); y += kAside) {
      near.clear();
      for (const TrayRider& rider : riders)
        if (rider.is_over({x, y, 0.0}, kFitOfTray + kWallOfTray)) near.push_back(&rider);
      const bool over_box = is_in({x, y, 0.0}, 0.0), in_room = is_in({x, y, 0.0}, kWallOfTray);
      if (!over_box && near.empty()) continue;
      for (double z = from.z() + 0.5 * kUp; z < top; z += kUp) {
        const Vector3d point(x, y, z);
        const bool is_over_box = over_box && z >= low.z();
        bool solid = is_over_box && z <= high.z() && (!is_hollow || !in_room || z < floor);
        for (const TrayRider* rider : near)
          solid = solid || rider->holds(point, floor, high.z(), is_over_box);
        if (!solid) continue;
        const bool is_cut = std::any_of(near.begin(), near.end(), [&](const TrayRider* rider) {
          return rider->takes_away(point);
        });
        if (!is_cut) ++count;
      }
    }
  const double mass =
      kSampledMore * assembly.link_density * static_cast<double>(count) * kAside * kAside * kUp;
  return std::ceil(kGramsOfTray * mass) / kGramsOfTray;
}

}  // namespace legwright
