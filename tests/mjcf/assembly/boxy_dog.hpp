// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright::test {

inline Module box_module(const char* name, ModuleKind kind, double mass,
                         const Eigen::Vector3d& size) {
  Module module;
  module.name = name;
  module.kind = kind;
  module.mass = mass;
  OutlineShape box;
  box.size = size;
  module.outline = {box};
  return module;
}

inline Module servo_module() {
  Module servo = box_module("S", ModuleKind::servo, 0.06, {0.028, 0.046, 0.034});
  ModuleJoint joint;
  joint.position = {0.0, 0.009, 0.017};
  joint.stall_torque = 1.5;
  joint.continuous_torque = 0.5;
  joint.reflected_inertia = 0.004;
  joint.range = {-2.5, 2.5};
  servo.joint = joint;
  return servo;
}

inline Module ball() {
  Module foot = box_module("ball", ModuleKind::foot, 0.01, {0.012, 0.0, 0.0});
  foot.outline[0].type = OutlineShape::Type::sphere;
  foot.friction = 0.7;
  return foot;
}

/// Four legs of two servos about lateral axes, stretched out downwards; links are capsules.
inline Assembly boxy_dog() {
  Assembly out;
  out.name = "dog";
  out.link_shape = LinkShape::capsule;
  out.trunk = box_module("trunk", ModuleKind::trunk, 0.4, {0.2, 0.09, 0.04});
  out.parts = {{box_module("pack", ModuleKind::battery, 0.2, {0.1, 0.03, 0.02}), {0, 0, 0.01}}};
  AssemblyLimb leg;
  leg.names = {"F", "H"};
  leg.hip = {0.09, 0.07, 0.0};
  leg.step = {-0.18, 0.0, 0.0};
  leg.mirrored = true;
  leg.foot = ball();
  leg.foot_offset = {0.0, 0.0, -0.09};
  for (const char* name : {"hip", "knee"}) {
    AssemblyJoint joint;
    joint.name = name;
    joint.link = std::string(name) + "_link";
    joint.servo = servo_module();
    if (!leg.joints.empty()) joint.offset = {0.0, 0.0, -0.09};
    leg.joints.push_back(joint);
  }
  out.limbs = {leg};
  return out;
}

inline Attachment attachment(const char* name, const Eigen::Vector3d& position,
                             const Eigen::Vector3d& normal) {
  return {name, false, position, normal, "", {}};
}

/// The dog with attachments on the ends and backs of its servos and on its feet.
inline Assembly hulled_dog() {
  Assembly out = boxy_dog();
  out.link_shape = LinkShape::hull;
  for (AssemblyJoint& joint : out.limbs[0].joints)
    joint.servo.attachments = {attachment("end", {0.0, -0.023, 0.0}, {0.0, -1.0, 0.0}),
                               attachment("back", {0.0, 0.0, -0.017}, {0.0, 0.0, -1.0})};
  out.limbs[0].foot.attachments = {attachment("top", {0.0, 0.0, 0.012}, {0.0, 0.0, 1.0})};
  return out;
}

}  // namespace legwright::test
