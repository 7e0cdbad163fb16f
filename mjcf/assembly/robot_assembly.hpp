// SPDX-License-Identifier: Apache-2.0
// A robot as an assembly of modules: a trunk, and limbs as chains of servos with the vectors
// between them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mjcf/assembly/module.hpp"

namespace legwright {

inline constexpr double kInThePlane = 1e-9;   // [m], of the mirror plane
inline constexpr double kSameHip = 1e-6;      // [m]; nearer hips are in one place
inline constexpr double kFootFriction = 0.8;  // of a foot whose module does not tell

/// A servo or a linear actuator of a limb and what it moves: the link to the next one, or to the
/// foot.
struct AssemblyJoint {
  std::string name;                                  // of the joint within its limb: "knee"
  std::string link;                                  // of the link that it moves: "shank"
  Module servo;                                      // or linear actuator
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // from the joint above it [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();   // a unit vector; the horn looks along it
  double roll = 0.0;                                 // of the servo's body about it [rad]
  std::optional<std::array<double, 2>> range;        // [rad]; none: the servo's
  // Pivots of a linear actuator, from the joint: of its rod on the link that it moves, of its body
  // on what carries it [m]. None: those of linear_joint.hpp.
  std::optional<Eigen::Vector3d> lever, mount;
  int line = 0;  // of the file; 0: not from one

  bool is_linear() const { return servo.kind == ModuleKind::linear; }
};

/// A limb as the file gives it: once for several, which are moved and mirrored.
struct AssemblyLimb {
  std::vector<std::string> names;                  // of its copies, one each
  Eigen::Vector3d hip = Eigen::Vector3d::Zero();   // of the first copy's first joint, in the trunk
  Eigen::Vector3d step = Eigen::Vector3d::Zero();  // from a copy to the next [m]
  bool mirrored = false;  // there is a mirror image in the x-z plane of each
  std::vector<AssemblyJoint> joints;
  Module foot;
  Eigen::Vector3d foot_offset = Eigen::Vector3d::Zero();  // from the last joint to its frame [m]
  int line = 0;                                           // of its hip in the file; 0: not from one
};

/// Something that rides on the trunk.
struct AssemblyPart {
  Module module;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // of its frame in the trunk's [m]
  int line = 0;                                        // of the file; 0: not from one
};

/// Which torque of a servo's figures is a joint's limit.
enum class TorqueLimit { stall, continuous };

/// What a link is between its modules: a printed hull from one to the other, or a capsule from
/// joint to joint.
enum class LinkShape { hull, capsule };

/// What printed parts are to keep, in every design.
struct PrintLimits {
  Eigen::Vector2d bed{0.22, 0.22};  // of the printer [m]
  double turn = 0.0;                // how far axes of joints may turn, either way [rad]
  double margin = 0.004;            // that stays free at each side of the bed [m]

  /// Of the bed what parts may lie on [m].
  Eigen::Vector2d room() const { return bed.array() - 2.0 * margin; }
};

/// Axes of all vectors are those of the trunk with all angles zero: x forward, y left, z up. SI
/// units.
struct Assembly {
  std::string name;
  Module trunk;                   // its frame is the trunk's
  bool trunk_as_printed = false;  // its mass is not the file's, but tray_mass()
  int trunk_line = 0;             // of its mass or module in the file; 0: not from one
  std::vector<AssemblyPart> parts;
  std::vector<AssemblyLimb> limbs;
  TorqueLimit torque = TorqueLimit::stall;
  double torque_share = 1.0;       // of that torque
  std::optional<double> armature;  // where a reflected inertia is not known [kg m2]
  LinkShape link_shape = LinkShape::hull;
  std::optional<double> link_radius;  // of pads and capsules; none: link_radius() [m]
  std::optional<double> link_wall;    // thickness of the pads; none: link_wall() [m]
  double link_clearance = 0.001;      // of hulls to the servos that turn them [m]
  double link_density = 1240.0;       // [kg/m3]
  bool only_feet_touch = false;       // else everything that is no neighbour may
  std::optional<PrintLimits> print;   // none: parts are not made to be printed
};

/// One limb of a robot: a copy, or a mirror image of one.
struct PlacedLimb {
  std::string name;
  const AssemblyLimb* of = nullptr;
  Eigen::Vector3d hip = Eigen::Vector3d::Zero();  // in the trunk [m]
  bool mirrored = false;

  /// A vector of the limb as this copy has it.
  Eigen::Vector3d vector(const Eigen::Vector3d& of_original) const;
  /// The axis of a hinge, about which the same angle is the mirrored motion.
  Eigen::Vector3d hinge(const Eigen::Vector3d& of_original) const;
};

/// Whether a linear actuator turns any joint.
bool has_linear_joints(const Assembly& assembly);

/// Every limb, in the order of the file; of mirror images the left one first, with L and R behind
/// their names.
std::vector<PlacedLimb> placed_limbs(const Assembly& assembly);

/// Torque limit of a joint [N m], force limit of a linear actuator [N]: the share of the one that
/// is asked for, of the stall torque where that is the continuous one and not known.
double torque_limit(const Assembly& assembly, const Module& servo);

}  // namespace legwright
