// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/printed_trunk.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/propose/module_overlaps.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kKeptOnTrunk = 1e-9;  // [m], of distances and sizes that stay as they are
// [m] around servos on the trunk: `legwright parts` takes its --fit and twice its --wall there.
constexpr double kCradle = 0.3e-3 + 2.0 * 1.2e-3;
constexpr double kCore = 0.5 * kToldOverlap;  // [m] of an outline, which its core leaves out

/// The poses of two riders that can be at once, of all combinations of what turns one of them.
std::vector<std::pair<std::size_t, std::size_t>> poses_at_once(
    const std::vector<std::size_t>& one, const std::vector<std::size_t>& other) {
  std::vector<std::size_t> all = one;
  for (const std::size_t turn : other)
    if (std::find(one.begin(), one.end(), turn) == one.end()) all.push_back(turn);
  const auto pose = [&all](const std::vector<std::size_t>& turns, std::size_t bounds) {
    std::size_t out = 0;
    for (std::size_t k = 0; k < turns.size(); ++k) {
      const auto at = std::find(all.begin(), all.end(), turns[k]) - all.begin();
      out |= (bounds >> at & 1U) << k;
    }
    return out;
  };
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t bounds = 0; bounds < std::size_t{1} << all.size(); ++bounds)
    out.emplace_back(pose(one, bounds), pose(other, bounds));
  return out;
}

/// A module whose outline is larger on all sides; smaller by what is less than 0.
Module with_grown_outline(Module module, double by) {
  for (OutlineShape& shape : module.outline) {
    const bool is_box = shape.type == OutlineShape::Type::box;
    const Vector3d more = Vector3d(is_box ? 2.0 : 1.0, 2.0, is_box ? 2.0 : 0.0) * by;
    shape.size = (shape.size + more).cwiseMax(0.5 * shape.size);
  }
  return module;
}

}  // namespace

Module with_cradle(Module servo) { return with_grown_outline(std::move(servo), kCradle); }

PrintedTrunk::PrintedTrunk(const Assembly& assembly)
    : room_(assembly.print->room()), clearance_(assembly.link_clearance - kKeptOnTrunk) {
  const ModuleExtent box = extent_of(assembly.trunk);
  low_ = box.middle - box.half;
  high_ = box.middle + box.half;
  for (const AssemblyPart& part : assembly.parts) {
    const Eigen::Isometry3d pose(Eigen::Translation3d(part.position));
    riders_.push_back({part.position,
                       outline_hulls(part.module, pose),
                       outline_hulls(with_grown_outline(part.module, -kCore), pose),
                       {},
                       ""});
  }
  for (const PlacedLimb& limb : placed_limbs(assembly)) {
    const AssemblyJoint& hip = limb.of->joints.front();
    const auto on_trunk = [&](const Module& servo) {
      OutlineHulls out = outline_hulls(servo, servo_pose(hip, towards_above(limb, 0)));
      for (OutlineHull& hull : out)
        for (Vector3d& point : hull.points) point = limb.hip + limb.vector(point);
      return out;
    };
    riders_.push_back({limb.hip, on_trunk(hip.servo),
                       on_trunk(with_grown_outline(hip.servo, -kCore)),
                       on_trunk(with_cradle(hip.servo)), limb.name});
  }
  const std::vector<PosedRider> drawn = all_posed(Vector3d::Ones(), {});
  drawn_size_ = size_of(drawn, Vector3d::Ones());
  for (std::size_t i = 0; i < drawn.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) drawn_.push_back(distance(drawn[i], 0, drawn[j], 0));
}

double PrintedTrunk::distance(const PosedRider& one, std::size_t pose, const PosedRider& other,
                              std::size_t its_pose) {
  const double apart = hull_distance(one.outlines[pose], other.outlines[its_pose]);
  if (apart > 0.0) return apart;
  return std::min(0.0, hull_distance(one.cores[pose], other.cores[its_pose]) - 2.0 * kCore);
}

bool PrintedTrunk::is_allowed(const Vector3d& scale, const std::vector<HipTurn>& hips) const {
  const std::vector<PosedRider> riders = all_posed(scale, hips);
  const Vector3d size = size_of(riders, scale);
  const bool has_not_grown =
      size.x() <= drawn_size_.x() + kKeptOnTrunk && size.y() <= drawn_size_.y() + kKeptOnTrunk;
  if (!has_not_grown && !lies_on_bed(size)) return false;
  std::size_t pair = 0;
  for (std::size_t i = 0; i < riders.size(); ++i)
    for (std::size_t j = 0; j < i; ++j, ++pair) {
      const double least = std::min(clearance_, drawn_[pair] - kKeptOnTrunk);
      for (const auto& [a, b] : poses_at_once(riders[i].turns, riders[j].turns))
        if (distance(riders[i], a, riders[j], b) < least) return false;
    }
  return true;
}

bool PrintedTrunk::lies_on_bed(const Vector3d& size) const {
  return (size.x() <= room_.x() && size.y() <= room_.y()) ||
         (size.x() <= room_.y() && size.y() <= room_.x());
}

PrintedTrunk::PosedRider PrintedTrunk::posed(const Rider& rider, const Vector3d& scale,
                                             const std::vector<HipTurn>& hips) const {
  PosedRider out;
  for (std::size_t k = 0; k < hips.size(); ++k)
    if (hips[k].about.count(rider.limb)) out.turns.push_back(k);
  const Vector3d place = scale.cwiseProduct(rider.place);
  for (std::size_t pose = 0; pose < std::size_t{1} << out.turns.size(); ++pose) {
    Eigen::Isometry3d move(Eigen::Translation3d{place});
    for (std::size_t k = 0; k < out.turns.size(); ++k) {
      const HipTurn& turn = hips[out.turns[k]];
      move.rotate(
          Eigen::AngleAxisd(pose >> k & 1U ? turn.high : turn.low, turn.about.at(rider.limb)));
    }
    move.translate(-rider.place);
    out.outlines.push_back(moved(rider.outline, move));
    out.cores.push_back(moved(rider.core, move));
    if (rider.cradle.empty()) continue;
    out.low.push_back(Vector3d::Constant(std::numeric_limits<double>::infinity()));
    out.high.push_back(-out.low.back());
    for (const OutlineHull& hull : moved(rider.cradle, move))
      for (const Vector3d& point : hull.points) {
        out.low.back() = out.low.back().cwiseMin(point - Vector3d::Constant(hull.radius));
        out.high.back() = out.high.back().cwiseMax(point + Vector3d::Constant(hull.radius));
      }
  }
  return out;
}

std::vector<PrintedTrunk::PosedRider> PrintedTrunk::all_posed(
    const Vector3d& scale, const std::vector<HipTurn>& hips) const {
  std::vector<PosedRider> out;
  for (const Rider& rider : riders_) out.push_back(posed(rider, scale, hips));
  return out;
}

Vector3d PrintedTrunk::size_of(const std::vector<PosedRider>& riders, const Vector3d& scale) const {
  std::vector<PosedRider> all = riders;
  all.push_back({{}, {}, {}, {low_.cwiseProduct(scale)}, {high_.cwiseProduct(scale)}});
  Vector3d out = Vector3d::Zero();
  for (const PosedRider& far : all)
    for (const PosedRider& near : all)
      for (const auto& [a, b] : poses_at_once(far.turns, near.turns))
        if (!far.high.empty() && !near.low.empty()) out = out.cwiseMax(far.high[a] - near.low[b]);
  return out;
}

}  // namespace legwright
