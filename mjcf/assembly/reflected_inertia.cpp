// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/reflected_inertia.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "mjcf/assembly/linear_joint.hpp"

namespace legwright {
namespace {

/// Fitted values of geared hobby servos for each N m of stall torque [kg m2], and one between. It
/// grows with the square of the ratio, and says nothing of brushless joints.
constexpr double kLeastInertia = 0.003, kMostInertia = 0.007, kInertia = 0.005, kLeastRatio = 100.0;

bool has_rule(const ModuleJoint& joint) {
  return !joint.gear_ratio || *joint.gear_ratio >= kLeastRatio;
}

}  // namespace

std::optional<double> reflected_inertia(const ModuleJoint& joint, const Assembly& assembly) {
  if (joint.reflected_inertia) return joint.reflected_inertia;
  if (assembly.armature) return assembly.armature;
  if (has_rule(joint)) return kInertia * joint.stall_torque;
  return std::nullopt;
}

std::optional<double> armature_of(const AssemblyJoint& joint, const Assembly& assembly) {
  if (!joint.is_linear()) return reflected_inertia(*joint.servo.joint, assembly);
  const ModuleSlide& slide = *joint.servo.slide;
  if (!slide.reflected_mass && assembly.armature) return assembly.armature;
  const double arm = moment_arm_at(joint, 0.0);
  if (const auto mass = reflected_mass(slide)) return *mass * arm * arm;
  return std::nullopt;
}

std::vector<std::string> notes_on_inertia(const Assembly& assembly) {
  std::set<std::string> taken, none, sliding;
  if (!assembly.armature)
    for (const AssemblyLimb& limb : assembly.limbs)
      for (const AssemblyJoint& joint : limb.joints) {
        if (joint.is_linear()) {
          const ModuleSlide& slide = *joint.servo.slide;
          if (slide.reflected_mass) continue;
          if (const auto mass = reflected_mass(slide))
            sliding.insert(fmt::format("{:.2g} kg of {}, {:.2g} kg m2 at {}", *mass,
                                       joint.servo.name, *armature_of(joint, assembly),
                                       joint.name));
          else
            none.insert(joint.servo.name);
          continue;
        }
        const ModuleJoint& servo = *joint.servo.joint;
        if (servo.reflected_inertia) continue;
        if (has_rule(servo))
          taken.insert(
              fmt::format("{:.2g} kg m2 of {}", kInertia * servo.stall_torque, joint.servo.name));
        else
          none.insert(joint.servo.name);
      }
  std::vector<std::string> out;
  if (!taken.empty())
    out.push_back(
        fmt::format("reflected inertia is not known and taken as {}: {} for each N m of stall "
                    "torque, where fits of geared hobby servos gave {} to {}; armature gives "
                    "another to all of them",
                    fmt::join(taken, ", "), kInertia, kLeastInertia, kMostInertia));
  if (!sliding.empty())
    out.push_back(fmt::format(
        "reflected mass is not known and taken as {}: 0.03 s times the force at rest over the "
        "speed without load, which fits of geared hobby servos come to; armature gives another to "
        "all of them",
        fmt::join(sliding, ", ")));
  if (!none.empty())
    out.push_back(
        fmt::format("the reflected inertia of {} is not known: their joints have no armature, "
                    "without which gaits hang on details; armature gives one: rotor inertia times "
                    "the square of the ratio",
                    fmt::join(none, ", ")));
  return out;
}

}  // namespace legwright
