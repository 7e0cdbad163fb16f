// SPDX-License-Identifier: Apache-2.0
// How bodies, joints, feet and motors of an assembled robot are named.
#pragma once

#include <string>
#include <vector>

#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// Of the hinge.
std::string joint_name(const PlacedLimb& limb, const AssemblyJoint& joint);
/// Of the servo's body, and of the motor.
std::string servo_name(const PlacedLimb& limb, const AssemblyJoint& joint);
/// Of the pivots of a linear actuator, which are sites: of its body, and of its rod.
std::string mount_name(const PlacedLimb& limb, const AssemblyJoint& joint);
std::string lever_name(const PlacedLimb& limb, const AssemblyJoint& joint);
/// Of the tendon between them.
std::string rod_name(const PlacedLimb& limb, const AssemblyJoint& joint);
/// Of the bodies that hold these pivots.
std::string mount_arm_name(const PlacedLimb& limb, const AssemblyJoint& joint);
std::string lever_arm_name(const PlacedLimb& limb, const AssemblyJoint& joint);
/// Of the body of the link that the joint moves.
std::string link_name(const PlacedLimb& limb, const AssemblyJoint& joint);
/// Of the body and the mesh of a hull of that link. @param role of the hull
std::string hull_name(const PlacedLimb& limb, const AssemblyJoint& joint, const std::string& role);
/// Of a shape of the foot's outline, counted from 0; the first has the limb's name.
std::string foot_name(const PlacedLimb& limb, std::size_t shape);
/// Of the body of a part, counted from 0.
std::string part_name(const AssemblyPart& part, std::size_t k);

/// One name that two things of a robot would have.
struct NameClash {
  std::string name;
  std::string first, second;  // what they are, in words of the assembly: `joint "knee" of limb "F"`
};

/// The names that a robot would have twice among bodies, hinges or geoms; of two limbs of the file
/// the first. Equal limbs, and equal joints or links in one limb, are none of them: the names
/// themselves are equal there.
std::vector<NameClash> name_clashes(const Assembly& assembly);

}  // namespace legwright
