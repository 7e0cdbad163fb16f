// SPDX-License-Identifier: Apache-2.0
#include "tools/assemble/assembly_spots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mjcf/text/input_error.hpp"
#include "tools/assemble/replaced_module.hpp"

namespace legwright {
namespace {

using As = AssemblySpot::As;
using Eigen::Vector3d;
using Kind = AssemblyItem::Kind;
using Takes = AssemblySpot::Takes;

constexpr double kCorner = 0.9;  // of half the trunk's length: where hips stand
constexpr double kTaken = 0.2;   // of the trunk's length, between a hip and a free spot
constexpr double kReach = 0.45;  // of the trunk's length: a new limb's first link
constexpr double kLeastReach = 0.04, kMostReach = 0.4;  // [m]
constexpr double kSideways = 0.5;                       // of a normal's height: less is sideways

class SpotFinder {
 public:
  explicit SpotFinder(const Assembly& assembly)
      : assembly_(assembly), trunk_(extent_of(assembly.trunk)), limbs_(placed_limbs(assembly)) {}

  std::vector<AssemblySpot> run() {
    add_new_limbs();
    for (std::size_t k = 0; k < assembly_.limbs.size(); ++k) add_of_limb(k);
    add_riders();
    out_.push_back({"trunk", "in the place of the trunk", Takes::trunk, As::replace, trunk_.middle,
                    Vector3d::Zero(), AssemblyItem{}});
    return out_;
  }

 private:
  void add(AssemblySpot spot) { out_.push_back(std::move(spot)); }

  /// Where no hip, nor the mirror image of one, is near.
  void add_new_limb(const std::string& id, const std::string& where, const Vector3d& at,
                    const Vector3d& normal) {
    const double far = kTaken * 2.0 * trunk_.half.x();
    for (const PlacedLimb& limb : limbs_) {
      const Vector3d way = limb.hip - at;
      const bool beyond = way.dot(normal) > -far;
      if (beyond && (way - way.dot(normal) * normal).norm() < far) return;
    }
    add({id, "a new limb at " + where, Takes::servo, As::new_limb, at, normal, {}});
  }

  void add_new_limbs() {
    const Vector3d &half = trunk_.half, &middle = trunk_.middle;
    const std::array<std::pair<const char*, double>, 3> rows{
        {{"front", kCorner}, {"middle", 0.0}, {"hind", -kCorner}}};
    for (const auto& [name, share] : rows)
      add_new_limb(fmt::format("side/{}", name), fmt::format("the trunk's left {}", name),
                   middle + Vector3d(share * half.x(), half.y(), 0.0), Vector3d::UnitY());
    for (const double sign : {1.0, -1.0}) {
      const char* const name = sign > 0.0 ? "front" : "hind";
      add_new_limb(fmt::format("face/{}", name), fmt::format("the trunk's {} face", name),
                   middle + Vector3d(sign * half.x(), 0.0, 0.0), sign * Vector3d::UnitX());
    }
    for (const Attachment& one : assembly_.trunk.attachments)
      if (std::abs(one.normal.z()) < kSideways && one.position.y() >= 0.0)
        add_new_limb("attachment/" + one.name, "the trunk's attachment " + one.name, one.position,
                     one.normal);
  }

  void add_of_limb(std::size_t index) {
    const AssemblyLimb& limb = assembly_.limbs[index];
    Vector3d at = limb.hip;
    for (std::size_t k = 0; k < limb.joints.size(); ++k) {
      const AssemblyItem item{Kind::joint, index, k};
      if (k > 0) {
        const Vector3d half = at + 0.5 * limb.joints[k].offset;
        add({fmt::format("limb/{}/before/{}", index, k),
             fmt::format("a joint before {} in {}", limb.joints[k].name, limb.names.front()),
             Takes::servo, As::insert, half, Vector3d::Zero(), item});
        at += limb.joints[k].offset;
      }
      add({to_string(item), "in the place of " + words_of(item, assembly_), Takes::servo,
           As::replace, at, Vector3d::Zero(), item});
    }
    const AssemblyItem foot{Kind::foot, index, 0};
    at += limb.foot_offset;
    add({fmt::format("limb/{}/end", index),
         fmt::format("a joint behind {} in {}", limb.joints.back().name, limb.names.front()),
         Takes::servo,
         As::insert,
         at,
         Vector3d::Zero(),
         {Kind::joint, index, limb.joints.size()}});
    add({to_string(foot), "in the place of " + words_of(foot, assembly_), Takes::foot, As::replace,
         at, Vector3d::Zero(), foot});
  }

  void add_riders() {
    for (std::size_t k = 0; k < assembly_.parts.size(); ++k) {
      const AssemblyItem item{Kind::part, k, 0};
      add({to_string(item), "in the place of " + words_of(item, assembly_), Takes::rider,
           As::replace, assembly_.parts[k].position, Vector3d::Zero(), item});
    }
    bool own = false;
    for (const Attachment& one : assembly_.trunk.attachments)
      if (std::abs(one.normal.z()) >= kSideways) {
        own = true;
        add({"ride/" + one.name,
             "on the trunk's " + one.name,
             Takes::rider,
             As::ride,
             one.position,
             one.normal,
             {}});
      }
    if (own) return;
    const Vector3d up(0.0, 0.0, trunk_.half.z());
    add({"ride/top",
         "on top of the trunk",
         Takes::rider,
         As::ride,
         trunk_.middle + up,
         Vector3d::UnitZ(),
         {}});
    add({"ride/middle",
         "in the trunk's middle",
         Takes::rider,
         As::ride,
         trunk_.middle,
         Vector3d::Zero(),
         {}});
    add({"ride/bottom",
         "below the trunk",
         Takes::rider,
         As::ride,
         trunk_.middle - up,
         -Vector3d::UnitZ(),
         {}});
  }

  const Assembly& assembly_;
  const ModuleExtent trunk_;
  const std::vector<PlacedLimb> limbs_;
  std::vector<AssemblySpot> out_;
};

AssemblySpot spot_named(const Assembly& assembly, const std::string& id) {
  for (const AssemblySpot& spot : assembly_spots(assembly))
    if (spot.id == id) return spot;
  throw InputError("'" + id + "' is no spot of this assembly: it is taken, or is not there");
}

/// A name that no limb has, neither as it is nor as a mirror image: F, M, H by where it is, else by
/// a number.
std::string free_limb_name(const Assembly& assembly, const AssemblySpot& spot) {
  const auto is_taken = [&](const std::string& name) {
    for (const AssemblyLimb& limb : assembly.limbs)
      for (const std::string& other : limb.names)
        for (const char* side : {"", "L", "R"})
          if (other == name + side || other + side == name) return true;
    return false;
  };
  std::string row = spot.id.starts_with("side/front")    ? "F"
                    : spot.id.starts_with("side/middle") ? "M"
                    : spot.id.starts_with("side/hind")   ? "H"
                                                         : "";
  if (!row.empty() && !is_taken(row)) return row;
  for (int k = 1;; ++k)
    if (std::string name = fmt::format("leg{}", k); !is_taken(name)) return name;
}

/// hip, knee, ankle, then by a number: what the limb has not yet.
std::string free_joint_name(const AssemblyLimb& limb) {
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(limb.joints.begin(), limb.joints.end(), [&](const AssemblyJoint& other) {
      return other.name == name || other.link == name + "_link";
    });
  };
  for (const char* name : {"hip", "knee", "ankle"})
    if (!is_taken(name)) return name;
  for (int k = 4;; ++k)
    if (std::string name = fmt::format("joint{}", k); !is_taken(name)) return name;
}

AssemblyJoint joint_of(const AssemblyLimb& limb, const Module& servo) {
  AssemblyJoint joint;
  joint.name = free_joint_name(limb);
  joint.link = joint.name + "_link";
  joint.servo = servo;
  return joint;
}

/// Hip and mirror image of a limb that begins there.
void place_limb(AssemblyLimb& limb, const AssemblySpot& spot) {
  limb.hip = spot.at + depth_behind_horn(limb.joints.front().servo) * spot.normal;
  limb.mirrored = std::abs(limb.hip.y()) > kInThePlane;
  limb.step.setZero();
}

AssemblyItem put_limb(Assembly& assembly, const AssemblySpot& spot, const Module& servo,
                      const Module& foot) {
  AssemblyLimb limb;
  limb.names = {free_limb_name(assembly, spot)};
  limb.joints = {joint_of(limb, servo)};
  limb.joints.front().axis = spot.normal.normalized();
  limb.foot = assembly.limbs.empty() ? foot : assembly.limbs.front().foot;
  const double length = 2.0 * extent_of(assembly.trunk).half.x();
  limb.foot_offset = -std::clamp(kReach * length, kLeastReach, kMostReach) * Vector3d::UnitZ();
  place_limb(limb, spot);
  assembly.limbs.push_back(limb);
  return {Kind::joint, assembly.limbs.size() - 1, 0};
}

AssemblyItem insert_joint(Assembly& assembly, const AssemblySpot& spot, const Module& servo) {
  AssemblyLimb& limb = assembly.limbs[spot.item.index];
  const std::size_t k = spot.item.joint;
  AssemblyJoint joint = joint_of(limb, servo);
  if (k == limb.joints.size()) {
    joint.offset = limb.foot_offset;
    joint.axis = limb.joints.back().axis;
  } else {
    joint.offset = limb.joints[k].offset *= 0.5;
    joint.axis = limb.joints[k].axis;
  }
  limb.joints.insert(limb.joints.begin() + static_cast<std::ptrdiff_t>(k), joint);
  return spot.item;
}

/// Its outline stands on the spot.
AssemblyItem put_rider(Assembly& assembly, const AssemblySpot& spot, const Module& module) {
  const ModuleExtent extent = extent_of(module);
  const Vector3d out = extent.half.dot(spot.normal.cwiseAbs()) * spot.normal;
  assembly.parts.push_back({module, spot.at + out - extent.middle});
  return {Kind::part, assembly.parts.size() - 1, 0};
}

}  // namespace

bool takes(const AssemblySpot& spot, ModuleKind kind) {
  switch (kind) {
    case ModuleKind::servo:
      return spot.takes == Takes::servo;
    case ModuleKind::linear:
      return spot.takes == Takes::servo && spot.as != As::new_limb && spot.item.joint > 0;
    case ModuleKind::foot:
      return spot.takes == Takes::foot;
    case ModuleKind::trunk:
      return spot.takes == Takes::trunk;
    case ModuleKind::battery:
    case ModuleKind::computer:
    case ModuleKind::payload:
      return spot.takes == Takes::rider;
  }
  return false;
}

std::vector<AssemblySpot> assembly_spots(const Assembly& assembly) {
  return SpotFinder(assembly).run();
}

AssemblyItem put_module(Assembly& assembly, const std::string& id, const Module& module,
                        const Module& foot) {
  const AssemblySpot spot = spot_named(assembly, id);
  if (!takes(spot, module.kind))
    throw InputError(fmt::format("'{}' takes no {}: it is {}", id, module.kind_name(), spot.words));
  switch (spot.as) {
    case As::new_limb:
      return put_limb(assembly, spot, module, foot);
    case As::insert:
      return insert_joint(assembly, spot, module);
    case As::ride:
      return put_rider(assembly, spot, module);
    case As::replace:
      replace_module(assembly, spot.item, module);
  }
  return spot.item;
}

AssemblyItem put_copy(Assembly& assembly, const std::string& id, std::size_t index) {
  const AssemblySpot spot = spot_named(assembly, id);
  if (spot.as != As::new_limb)
    throw InputError(fmt::format("'{}' begins no limb: it is {}", id, spot.words));
  AssemblyLimb limb = assembly.limbs.at(index);
  limb.names = {free_limb_name(assembly, spot)};
  place_limb(limb, spot);
  assembly.limbs.push_back(limb);
  return {Kind::limb, assembly.limbs.size() - 1, 0};
}

}  // namespace legwright
