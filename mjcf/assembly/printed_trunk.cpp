// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/printed_trunk.hpp"

#include <algorithm>

#include "mjcf/assembly/limb_hulls.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kKeptOnTrunk = 1e-9;  // [m], of distances and sizes that stay as they are
// [m] around servos on the trunk: `legwright parts` takes its --fit and twice its --wall there.
constexpr double kCradle = 0.3e-3 + 2.0 * 1.2e-3;

}  // namespace

Module with_cradle(Module servo) {
  for (OutlineShape& shape : servo.outline) {
    const bool is_box = shape.type == OutlineShape::Type::box;
    shape.size += Vector3d(is_box ? 2.0 : 1.0, 2.0, is_box ? 2.0 : 0.0) * kCradle;
  }
  return servo;
}

PrintedTrunk::PrintedTrunk(const Assembly& assembly)
    : bed_(assembly.print->bed), clearance_(assembly.link_clearance - kKeptOnTrunk) {
  const ModuleExtent box = extent_of(assembly.trunk);
  low_ = box.middle - box.half;
  high_ = box.middle + box.half;
  for (const AssemblyPart& part : assembly.parts) {
    const Eigen::Isometry3d pose(Eigen::Translation3d(part.position));
    riders_.push_back({part.position, outline_hulls(part.module, pose), {}, "", false});
  }
  for (const PlacedLimb& limb : placed_limbs(assembly)) {
    const AssemblyJoint& hip = limb.of->joints.front();
    const auto on_trunk = [&](const Module& servo) {
      OutlineHulls out = outline_hulls(servo, servo_pose(hip, towards_above(limb, 0)));
      for (OutlineHull& hull : out)
        for (Vector3d& point : hull.points) point = limb.hip + limb.vector(point);
      return out;
    };
    riders_.push_back({limb.hip, on_trunk(hip.servo), on_trunk(with_cradle(hip.servo)), limb.name,
                       limb.mirrored});
  }
  drawn_size_ = size_at(Vector3d::Ones());
  for (const auto& [i, j] : pairs()) drawn_.push_back(distance(i, j, Vector3d::Ones()));
}

bool PrintedTrunk::is_allowed(const Vector3d& scale) const {
  const Vector3d size = size_at(scale);
  const bool has_not_grown =
      size.x() <= drawn_size_.x() + kKeptOnTrunk && size.y() <= drawn_size_.y() + kKeptOnTrunk;
  return (has_not_grown || lies_on_bed(size)) && is_clear(scale);
}

PrintedTrunk PrintedTrunk::turned(const std::vector<std::string>& limbs,
                                  const Eigen::Matrix3d& turn) const {
  PrintedTrunk out = *this;
  for (Rider& rider : out.riders_) {
    if (std::find(limbs.begin(), limbs.end(), rider.limb) == limbs.end()) continue;
    Eigen::Matrix3d own = turn;
    if (rider.mirrored)
      for (const Eigen::Index k : {0, 2}) {  // across the x-z plane
        own(k, 1) *= -1.0;
        own(1, k) *= -1.0;
      }
    for (OutlineHulls* hulls : {&rider.outline, &rider.cradle})
      for (OutlineHull& hull : *hulls)
        for (Vector3d& point : hull.points) point = rider.place + own * (point - rider.place);
  }
  return out;
}

bool PrintedTrunk::is_clear(const Vector3d& scale) const {
  std::size_t k = 0;
  for (const auto& [i, j] : pairs())
    if (distance(i, j, scale) < std::min(clearance_, drawn_[k++] - kKeptOnTrunk)) return false;
  return true;
}

bool PrintedTrunk::lies_on_bed(const Vector3d& size) const {
  return (size.x() <= bed_.x() && size.y() <= bed_.y()) ||
         (size.x() <= bed_.y() && size.y() <= bed_.x());
}

std::vector<std::pair<std::size_t, std::size_t>> PrintedTrunk::pairs() const {
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t i = 0; i < riders_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) out.emplace_back(i, j);
  return out;
}

OutlineHulls PrintedTrunk::at(const OutlineHulls& of, const Rider& rider, const Vector3d& scale) {
  const Vector3d by = (scale - Vector3d::Ones()).cwiseProduct(rider.place);
  return moved(of, Eigen::Isometry3d(Eigen::Translation3d(by)));
}

double PrintedTrunk::distance(std::size_t i, std::size_t j, const Vector3d& scale) const {
  return hull_distance(at(riders_[i].outline, riders_[i], scale),
                       at(riders_[j].outline, riders_[j], scale));
}

Vector3d PrintedTrunk::size_at(const Vector3d& scale) const {
  Vector3d low = low_.cwiseProduct(scale), high = high_.cwiseProduct(scale);
  for (const Rider& rider : riders_)
    for (const OutlineHull& hull : at(rider.cradle, rider, scale))
      for (const Vector3d& point : hull.points) {
        low = low.cwiseMin(point - Vector3d::Constant(hull.radius));
        high = high.cwiseMax(point + Vector3d::Constant(hull.radius));
      }
  return high - low;
}

}  // namespace legwright
