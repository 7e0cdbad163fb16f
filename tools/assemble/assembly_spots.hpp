// SPDX-License-Identifier: Apache-2.0
// Where on an assembly a module can be put, and what becomes of it there.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "mjcf/assembly/robot_assembly.hpp"
#include "tools/assemble/assembly_item.hpp"

namespace legwright {

/// A place that takes a module of some kind.
struct AssemblySpot {
  enum class Takes { servo, foot, trunk, rider };  // rider: battery, computer, payload
  /// What becomes of it there.
  enum class As { new_limb, insert, replace, ride };
  std::string id;     // "limb/0/end", "side/front"
  std::string words;  // "a new limb at the trunk's left front"
  Takes takes = Takes::servo;
  As as = As::replace;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();      // in the trunk's frame, all angles zero [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // of new limbs and riders: out of the trunk
  AssemblyItem item;                                 // what is replaced, or in which limb it goes
};

/// Whether a module of this kind goes to such a spot.
bool takes(const AssemblySpot& spot, ModuleKind kind);

/// All of them. New limbs are offered where no other hip is near: at the left front, middle and
/// hind of the trunk's outline, whose mirror images appear by themselves, at its front and hind
/// faces, and at the trunk's own attachments that look sideways. A servo goes before each joint but
/// the first, and behind the last, and so does a linear actuator, which begins no limb and is no
/// hip; riders go on the trunk's attachments that look up or down, else on its faces and into its
/// middle.
std::vector<AssemblySpot> assembly_spots(const Assembly& assembly);

/// Puts a module there. What is behind an inserted servo stays where it is; behind the last joint
/// the foot goes as far beyond it as it was before. A new limb stands on the trunk's face by its
/// servo's outline, with its axis out of the trunk, and reaches down. What goes along with a module
/// of another size replace_module() says. Throws InputError for a spot that is none, or takes no
/// module of this kind.
/// @param foot of a new limb, where no other has one @return what was put
AssemblyItem put_module(Assembly& assembly, const std::string& spot, const Module& module,
                        const Module& foot);

/// Puts a limb like another one there, with joints, vectors and foot of its own. Throws InputError
/// for a spot where no limb can begin.
AssemblyItem put_copy(Assembly& assembly, const std::string& spot, std::size_t limb);

}  // namespace legwright
