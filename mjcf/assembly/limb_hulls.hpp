// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "mjcf/assembly/link_hulls.hpp"
#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// A servo with its horn at the origin, looking along the joint's axis, its body towards what
/// carries it. @param towards in the axes of the trunk
Eigen::Isometry3d servo_pose(const AssemblyJoint& joint, const Eigen::Vector3d& towards);

/// The direction in which that is: the joint above; of a hip the trunk's middle.
/// In the axes of the limb as the file gives it, not mirrored.
Eigen::Vector3d towards_above(const PlacedLimb& limb, std::size_t joint);

/// What the link that a joint of the limb moves holds together. Points into the limb.
LinkEnds link_ends(const PlacedLimb& limb, std::size_t joint);

/// The hulls of that link as drawn.
LinkHulls hulls_of_link(const Assembly& assembly, const PlacedLimb& limb, std::size_t joint);

/// Whether a linear actuator turns the link that a joint of a limb moves, or the next one: then it
/// holds a hinge and a pivot in place of a horn, and is a capsule.
bool at_linear_joint(const AssemblyLimb& limb, std::size_t joint);

/// The printed parts of a limb, by its joints: those of the link that each moves, in the axes of
/// the limb as the file gives it. None where links are capsules, and at_linear_joint().
std::vector<LinkHulls> limb_hulls(const Assembly& assembly, const PlacedLimb& limb);

/// A hull of one limb of the robot as it stands in the file.
struct WrittenHull {
  std::string vertices;  // of its mesh
  std::string inertial;  // attributes of its <inertial>
  std::string data;      // of the <text> that declares it (read_connectors())
};

/// @param joint of the link, with whose axis its points there turn. @param end "body NAME" or
/// "geom NAME", which goes with the points at the other end. @param place of that in the link, of
/// the limb as the file gives it [m]. @param from where these points are from, as seen from there
/// [m]
WrittenHull written_hull(const LinkHull& hull, const PlacedLimb& limb, double density,
                         const std::string& joint, const std::string& end,
                         const Eigen::Vector3d& place, const Eigen::Vector3d& from);

}  // namespace legwright
