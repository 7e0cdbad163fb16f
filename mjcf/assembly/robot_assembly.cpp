// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/robot_assembly.hpp"

#include <algorithm>
#include <cstddef>

#include "mjcf/read/mirror.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

}  // namespace

Vector3d PlacedLimb::vector(const Vector3d& of_original) const {
  return mirrored ? point_in_mirror(of_original, Across::y) : of_original;
}

Vector3d PlacedLimb::hinge(const Vector3d& of_original) const {
  return mirrored ? turn_in_mirror(of_original, Across::y) : of_original;
}

bool has_linear_joints(const Assembly& assembly) {
  return std::any_of(assembly.limbs.begin(), assembly.limbs.end(), [](const AssemblyLimb& limb) {
    return std::any_of(limb.joints.begin(), limb.joints.end(),
                       [](const AssemblyJoint& joint) { return joint.is_linear(); });
  });
}

std::vector<PlacedLimb> placed_limbs(const Assembly& assembly) {
  std::vector<PlacedLimb> out;
  for (const AssemblyLimb& limb : assembly.limbs)
    for (std::size_t copy = 0; copy < limb.names.size(); ++copy) {
      PlacedLimb placed{limb.names[copy], &limb, limb.hip + static_cast<double>(copy) * limb.step,
                        false};
      if (!limb.mirrored) {
        out.push_back(placed);
        continue;
      }
      PlacedLimb image = placed;
      image.mirrored = true;
      image.hip = image.vector(placed.hip);
      const bool left = placed.hip.y() >= -kInThePlane;
      placed.name += left ? "L" : "R";
      image.name += left ? "R" : "L";
      if (!left) std::swap(placed, image);
      out.push_back(placed);
      out.push_back(image);
    }
  return out;
}

double torque_limit(const Assembly& assembly, const Module& servo) {
  if (servo.slide) {
    const ModuleSlide& slide = *servo.slide;
    const bool rated = assembly.torque == TorqueLimit::continuous;
    return assembly.torque_share *
           (rated ? slide.continuous_force.value_or(slide.most_force) : slide.most_force);
  }
  const ModuleJoint& joint = *servo.joint;
  const double whole = assembly.torque == TorqueLimit::continuous
                           ? joint.continuous_torque.value_or(joint.stall_torque)
                           : joint.stall_torque;
  return assembly.torque_share * whole;
}

}  // namespace legwright
