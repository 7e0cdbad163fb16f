// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/link_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kLinkRadius = 0.006;   // [m]
constexpr double kAroundHole = 1.2e-3;  // [m] of material: three lines of a nozzle of 0.4 mm
constexpr double kPadRadii = 1e4;       // in a metre, to the next of which they are rounded up
constexpr double kCornersOfPad = 8.0;   // whose flat sides are nearer than their radius
constexpr double kHornOfWidth = 0.4;    // a horn's radius, of the width of its servo
constexpr double kMostHorn = 0.015;     // [m]
constexpr double kPadInBall = 0.75;     // radius of a pad in a ball foot, of the ball's
constexpr double kLinkWall = 0.003;     // [m]
constexpr double kUnderHead = 1.1;      // of a hole's diameter: what a head that is let in clamps
constexpr double kMostWall = 0.012;     // [m]: what is thicker stands in its own way
constexpr double kWalls = 2e3;          // in a metre, to the next of which they are rounded up
// `legwright parts` takes --strength and --safety for these.
constexpr double kStrength = 25e6;  // [Pa], of PLA across its layers
constexpr double kSafety = 2.0;
// What plates lack that holes, seats of modules and octagons take, as measured of printed links:
// times the stress of a whole plate in its plane, and across it.
constexpr double kLostInPlane = 2.0, kLostAcross = 2.5;
constexpr double kPeak = 1.5;           // of a foot's share of the weight, of half of the feet
constexpr double kLevelForce = 0.3;     // of the ground's force, in any level direction
constexpr double kWithPrint = 1.25;     // mass of a robot, of that of its modules
constexpr double kWeightOfMass = 9.81;  // [m/s2]

/// Diameter of the holes for the screws of an attachment [m]; 0 where these are not known.
double hole_of(const Attachment& at) {
  const auto size = std::find(kScrewSizes.begin(), kScrewSizes.end(), at.screws);
  if (size == kScrewSizes.end()) return 0.0;
  return kScrewHoles[static_cast<std::size_t>(size - kScrewSizes.begin())];
}

/// Of the pads that hold these screws [m].
double pad_radius(const Attachment& at) {
  const double hole = hole_of(at);
  if (hole == 0.0) return 0.0;
  double needed = 0.0;
  for (const Vector3d& each : at.holes)
    needed = std::max(needed, (each - at.position).norm() + 0.5 * hole + kAroundHole);
  return std::ceil(kPadRadii * needed / std::cos(std::numbers::pi / kCornersOfPad)) / kPadRadii;
}

/// Of a pad on a servo's horn whose screws are not known: by the narrower side of what it is on.
double horn_radius(const Module& servo) {
  const Vector3d half = extent_of(servo).half;
  Eigen::Index along = 0;
  servo.joint->axis.cwiseAbs().maxCoeff(&along);
  const double narrow = 2.0 * std::min(half[(along + 1) % 3], half[(along + 2) % 3]);
  return std::min(kMostHorn, std::ceil(kPadRadii * kHornOfWidth * narrow) / kPadRadii);
}

std::size_t feet_of(const Assembly& assembly) {
  std::size_t out = 0;
  for (const AssemblyLimb& limb : assembly.limbs)
    out += limb.names.size() * (limb.mirrored ? 2 : 1);
  return out;
}

/// The ground's force on a foot that parts are made for [N].
double force_on_foot(const Assembly& assembly) {
  double mass = assembly.trunk.mass;
  for (const AssemblyPart& part : assembly.parts) mass += part.module.mass;
  for (const AssemblyLimb& limb : assembly.limbs) {
    double own = limb.foot.mass;
    for (const AssemblyJoint& joint : limb.joints) own += joint.servo.mass;
    mass += own * static_cast<double>(limb.names.size() * (limb.mirrored ? 2 : 1));
  }
  const double stand = std::max(1.0, 0.5 * static_cast<double>(feet_of(assembly)));
  return kPeak * kWithPrint * mass * kWeightOfMass / stand;
}

/// The moment about a joint, across its axis, of the ground's force on the foot beyond it, as drawn
/// [N m].
double moment_across(const AssemblyLimb& limb, std::size_t joint, double force) {
  Vector3d to_foot = limb.foot_offset;
  for (std::size_t k = joint + 1; k < limb.joints.size(); ++k) to_foot += limb.joints[k].offset;
  const Vector3d whole = to_foot.cross(force * Vector3d::UnitZ()), axis = limb.joints[joint].axis;
  return std::max((whole - whole.dot(axis) * axis).norm(), kLevelForce * force * to_foot.norm());
}

}  // namespace

double link_radius(const Assembly& assembly) {
  if (assembly.link_radius) return *assembly.link_radius;
  double radius = kLinkRadius;
  if (!assembly.print) return radius;
  for (const AssemblyLimb& limb : assembly.limbs)
    for (const AssemblyJoint& joint : limb.joints) {
      double own = 0.0;
      for (const Attachment& at : joint.servo.attachments) own = std::max(own, pad_radius(at));
      if (own == 0.0 && joint.servo.joint) own = horn_radius(joint.servo);
      radius = std::max(radius, own);
    }
  return radius;
}

double end_radius(const Assembly& assembly, const Module& other) {
  const double radius = link_radius(assembly);
  const bool is_ball =
      other.kind == ModuleKind::foot && other.outline.front().type == OutlineShape::Type::sphere;
  if (!assembly.print || assembly.link_radius || !is_ball) return radius;
  double screws = 0.0;
  for (const Attachment& at : other.attachments) screws = std::max(screws, pad_radius(at));
  return std::max(screws, std::min(radius, kPadInBall * other.outline.front().size.x()));
}

double link_wall(const Assembly& assembly) {
  if (assembly.link_wall) return *assembly.link_wall;
  double wall = kLinkWall;
  if (!assembly.print) return wall;
  const double wide = 2.0 * link_radius(assembly), force = force_on_foot(assembly);
  for (const AssemblyLimb& limb : assembly.limbs)
    for (std::size_t k = 0; k < limb.joints.size(); ++k) {
      const double torque = torque_limit(assembly, limb.joints[k].servo),
                   across = moment_across(limb, k, force);
      for (const Attachment& at : limb.joints[k].servo.attachments)
        wall = std::max(wall, kUnderHead * hole_of(at));
      // Section moduli of a plate: wall wide^2 / 6 in its plane, wide wall^2 / 6 across it.
      wall = std::max(wall, 6.0 * kLostInPlane * torque / (kStrength * wide * wide));
      wall = std::max(wall, std::sqrt(6.0 * kLostAcross * kSafety * across / (kStrength * wide)));
    }
  return std::min(kMostWall, std::ceil(kWalls * wall - 1e-6) / kWalls);
}

}  // namespace legwright
