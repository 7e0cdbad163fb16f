// SPDX-License-Identifier: Apache-2.0
// The printed parts of a link: convex hulls from the horn that turns it to the next module.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "mjcf/assembly/outline_hulls.hpp"
#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// A hull by its points [m]: those that stay with the link's own hinge, and those that go with the
/// module at its other end, each from the origin of that, in the axes of the link.
struct LinkHull {
  std::string role;  // "arm": reaches the other module; "boss": from the horn to an arm
  std::vector<Eigen::Vector3d> near, far;
};

/// The hulls of a link, and how near they come to the servo that turns it.
struct LinkHulls {
  std::vector<LinkHull> hulls;  // none where the modules have no attachments that face each other
  double clearance = std::numeric_limits<double>::infinity();  // [m]
  // The attachment of the other module where a cable leaves, if no other faces the horn; else
  // empty.
  std::string cable_at{};
};

/// What a link holds together, with all angles zero, in its axes.
struct LinkEnds {
  const Module* servo = nullptr;  // that turns it, with its horn at the origin
  Eigen::Isometry3d servo_pose = Eigen::Isometry3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();               // of the hinge, out of the servo
  std::array<double, 2> range{0.0, 0.0};                         // of its angle [rad]
  const Module* other = nullptr;                                 // the next servo, or the foot
  Eigen::Isometry3d other_pose = Eigen::Isometry3d::Identity();  // from its place
  Eigen::Vector3d place = Eigen::Vector3d::Zero();               // of the joint or foot there [m]
};

/// Angles of a joint's range at which distances are sampled, both ends among them.
inline constexpr int kSampledAngles = 61;
/// Link ← what carries its servo, about the hinge, at one of these.
Eigen::Isometry3d turn_to_link(const LinkEnds& ends, int sample);
/// The body of the servo that turns the link, as the link sees it at one of these.
OutlineHulls servo_seen_from_link(const LinkEnds& ends, int sample);
/// The module at the link's other end.
OutlineHulls other_end_of_link(const LinkEnds& ends);

/// What link_hulls() makes pads of [m].
struct PadSizes {
  double radius = 0.0;      // on the horn, and of bosses
  double end_radius = 0.0;  // on the other module
  double wall = 0.0;        // thickness
  double clearance = 0.0;   // to the servo that turns the link
};

/// Pads on the horn and on those attachments of the other module that face it, as thick as the
/// wall, and their hull. Where that would come nearer to the servo than the clearance, at an angle
/// at which the modules themselves keep it, the way goes round the servo: along the horn's plane
/// in a boss, and from there in an arm; where the other module is too near for that, the arm's end
/// is pulled back before the horn's plane. Sampled over the range.
LinkHulls link_hulls(const LinkEnds& ends, const PadSizes& pads);

}  // namespace legwright
