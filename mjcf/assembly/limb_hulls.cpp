// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/limb_hulls.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mjcf/assembly/link_sizes.hpp"
#include "mjcf/text/numbers.hpp"
#include "mjcf/write/connector_hulls.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kRoundBody = 1e-9;   // [m]: an outline about its axis, which has no long side
constexpr double kPointGrain = 1e12;  // per m: finer than what hulls take to be in one plane

/// A unit vector across `axis`, as near to `wanted` as can be; of those that are along it another.
Vector3d side_of_axis(const Vector3d& axis, const Vector3d& wanted) {
  const Vector3d rest = wanted - axis.dot(wanted) * axis;
  if (rest.norm() > kRoundBody) return rest.normalized();
  const Vector3d other = std::abs(axis.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitZ();
  return (other - axis.dot(other) * axis).normalized();
}

/// Right-handed: the first column along `axis`, the second along `side`, which is square to it.
Matrix3d frame_along(const Vector3d& axis, const Vector3d& side) {
  Matrix3d out;
  out << axis, side, axis.cross(side);
  return out;
}

Vector3d on_the_grain(const Vector3d& point) {
  Vector3d out;
  for (Eigen::Index k = 0; k < 3; ++k) {
    out[k] = std::round(point[k] * kPointGrain) / kPointGrain;
    if (out[k] == 0.0) out[k] = 0.0;  // no negative zero
  }
  return out;
}

std::string words_of(const std::vector<Vector3d>& points) {
  std::vector<std::string> words;
  words.reserve(points.size());
  for (const Vector3d& point : points) words.push_back(rounded_words(point));
  return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

Eigen::Isometry3d servo_pose(const AssemblyJoint& joint, const Vector3d& towards) {
  const ModuleJoint& own = *joint.servo.joint;
  const Vector3d body = inertia_of(joint.servo).centre - own.position;
  const Matrix3d of_module = frame_along(own.axis, side_of_axis(own.axis, body)),
                 placed = Eigen::AngleAxisd(joint.roll, joint.axis) *
                          frame_along(joint.axis, side_of_axis(joint.axis, towards));
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.linear() = placed * of_module.transpose();
  out.translation() = -(out.linear() * own.position);
  return out;
}

Vector3d towards_above(const PlacedLimb& limb, std::size_t joint) {
  return joint == 0 ? Vector3d(-limb.vector(limb.hip)) : Vector3d(-limb.of->joints[joint].offset);
}

LinkEnds link_ends(const PlacedLimb& placed, std::size_t k) {
  const AssemblyLimb& limb = *placed.of;
  const AssemblyJoint& joint = limb.joints[k];
  const bool is_last = k + 1 == limb.joints.size();
  LinkEnds out;
  out.servo = &joint.servo;
  out.servo_pose = servo_pose(joint, towards_above(placed, k));
  out.axis = joint.axis;
  out.range = joint.range.value_or(
      joint.servo.joint->range.value_or(std::array{-std::numbers::pi, std::numbers::pi}));
  out.other = is_last ? &limb.foot : &limb.joints[k + 1].servo;
  out.place = is_last ? limb.foot_offset : limb.joints[k + 1].offset;
  if (!is_last) out.other_pose = servo_pose(limb.joints[k + 1], towards_above(placed, k + 1));
  return out;
}

LinkHulls hulls_of_link(const Assembly& assembly, const PlacedLimb& limb, std::size_t joint) {
  const LinkEnds ends = link_ends(limb, joint);
  return link_hulls(ends, {link_radius(assembly), end_radius(assembly, *ends.other),
                           link_wall(assembly), assembly.link_clearance});
}

bool at_linear_joint(const AssemblyLimb& limb, std::size_t joint) {
  return limb.joints[joint].is_linear() ||
         (joint + 1 < limb.joints.size() && limb.joints[joint + 1].is_linear());
}

std::vector<LinkHulls> limb_hulls(const Assembly& assembly, const PlacedLimb& placed) {
  std::vector<LinkHulls> out(placed.of->joints.size());
  if (assembly.link_shape == LinkShape::capsule) return out;
  for (std::size_t k = 0; k < out.size(); ++k)
    if (!at_linear_joint(*placed.of, k)) out[k] = hulls_of_link(assembly, placed, k);
  return out;
}

WrittenHull written_hull(const LinkHull& hull, const PlacedLimb& limb, double density,
                         const std::string& joint, const std::string& end, const Vector3d& place,
                         const Vector3d& from) {
  std::vector<Vector3d> near, far, all;
  for (const Vector3d& point : hull.near) near.push_back(on_the_grain(limb.vector(point)));
  for (const Vector3d& point : hull.far) far.push_back(on_the_grain(limb.vector(point - from)));
  all = near;
  for (const Vector3d& point : far) all.emplace_back(limb.vector(place + from) + point);
  const std::vector<Facet> facets = convex_hull(all);
  const SolidInertial own = inertial_of(moments_of_solid(facets, all), density);
  WrittenHull out;
  out.vertices = rounded_words(vertices_of(facets, all));
  out.inertial = fmt::format("pos=\"{}\" mass=\"{}\" fullinertia=\"{}\"", rounded_words(own.centre),
                             format_number(rounded(own.mass)), rounded_words(own.full));
  out.data = fmt::format("{} kg/m3 | joint {}: {}", format_number(density), joint, words_of(near));
  if (!far.empty()) out.data += fmt::format(" | {}: {}", end, words_of(far));
  return out;
}

}  // namespace legwright
