// SPDX-License-Identifier: Apache-2.0
#include "tools/assemble/replaced_module.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

using Eigen::Vector3d;
using Kind = AssemblyItem::Kind;

constexpr double kOnTop = 1e-6;  // [m]: nearer to a face of the trunk is on it

/// Places about a box as they are about another one.
class OtherBox {
 public:
  OtherBox(const ModuleExtent& from, const ModuleExtent& to) : from_(from), to_(to) {}

  /// Whether both are boxes and differ.
  bool moves() const {
    const bool boxes = from_.half.minCoeff() > 0.0 && to_.half.minCoeff() > 0.0;
    return boxes && !(from_.half == to_.half && from_.middle == to_.middle);
  }

  Vector3d operator()(const Vector3d& point) const {
    Vector3d out;
    for (int k = 0; k < 3; ++k) {
      const double way = point[k] - from_.middle[k];
      const double beyond = std::max(0.0, std::abs(way) - from_.half[k]);
      const double share = std::min(1.0, std::abs(way) / from_.half[k]);
      out[k] = to_.middle[k] + std::copysign(share * to_.half[k] + beyond, way);
    }
    return out;
  }

 private:
  ModuleExtent from_, to_;
};

void replace_trunk(Assembly& assembly, const Module& module) {
  const OtherBox there(extent_of(assembly.trunk), extent_of(module));
  assembly.trunk = module;
  if (!there.moves()) return;
  for (AssemblyLimb& limb : assembly.limbs) {
    const Vector3d first = limb.hip;
    limb.hip = there(first);
    const auto steps = static_cast<double>(limb.names.size() - 1);
    if (steps > 0.0) limb.step = (there(first + steps * limb.step) - limb.hip) / steps;
  }
  for (AssemblyPart& part : assembly.parts) {
    const Vector3d middle = extent_of(part.module).middle;
    part.position = there(part.position + middle) - middle;
  }
}

void replace_servo(AssemblyLimb& limb, std::size_t joint, const Module& servo) {
  AssemblyJoint& at = limb.joints[joint];
  if (joint == 0)
    limb.hip += (depth_behind_horn(servo) - depth_behind_horn(at.servo)) * at.axis.normalized();
  at.servo = servo;
  at.mount.reset();  // of another length
  if (!at.is_linear()) at.lever.reset();
}

void replace_rider(Assembly& assembly, AssemblyPart& part, const Module& module) {
  const ModuleExtent trunk = extent_of(assembly.trunk), old = extent_of(part.module),
                     next = extent_of(module);
  const Vector3d middle = part.position + old.middle;
  Vector3d out = Vector3d::Zero();  // of the trunk, where the rider stands on it
  for (int k = 0; k < 3; ++k) {
    const double way = middle[k] - trunk.middle[k];
    const bool outside = std::abs(way) - old.half[k] > trunk.half[k] - kOnTop;
    if (outside) out[k] = std::copysign(1.0, way);
  }
  part.position = middle + out.cwiseProduct(next.half - old.half) - next.middle;
  part.module = module;
}

}  // namespace

double depth_behind_horn(const Module& servo) {
  const ModuleExtent extent = extent_of(servo);
  const Vector3d axis = servo.joint->axis;
  return (servo.joint->position - extent.middle).dot(axis) + extent.half.dot(axis.cwiseAbs());
}

void replace_module(Assembly& assembly, const AssemblyItem& item, const Module& module) {
  switch (item.kind) {
    case Kind::trunk:
      return replace_trunk(assembly, module);
    case Kind::part:
      return replace_rider(assembly, assembly.parts[item.index], module);
    case Kind::foot:
      assembly.limbs[item.index].foot = module;
      return;
    case Kind::joint:
      return replace_servo(assembly.limbs[item.index], item.joint, module);
    case Kind::limb:
      return;  // a chain of modules, none itself
  }
}

}  // namespace legwright
