// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/printed_link.hpp"

#include <algorithm>
#include <array>

#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/assembly/printed_trunk.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kKeptByLinks = 1e-9;  // [m], of distances that stay as they are
constexpr double kPeg = 0.3;           // radius of the peg that holds a ball foot, of the ball's

/// Printed parts, the points at whose far end are from `place`.
OutlineHulls parts_at(const std::vector<LinkHull>& hulls, const Vector3d& place) {
  OutlineHulls out;
  for (const LinkHull& hull : hulls) {
    out.push_back({hull.near, 0.0});
    for (const Vector3d& point : hull.far) out.back().points.emplace_back(place + point);
  }
  return out;
}

/// Where a link's length is measured to, from its place there: a foot's middle, or the next joint.
Vector3d end_of_length(const LinkEnds& ends) {
  return ends.other->kind == ModuleKind::foot ? ends.other->outline.front().position
                                              : Vector3d(Vector3d::Zero());
}

/// What carries a link's servo, from the joint there: the trunk with the servo's cradle, or the
/// parts of the link above.
OutlineHulls carrier_of(const Assembly& assembly, const PlacedLimb& limb, std::size_t joint) {
  const AssemblyJoint& own = limb.of->joints[joint];
  if (joint == 0) {
    Eigen::Isometry3d from_hip(Eigen::Translation3d(-limb.vector(limb.hip)));
    if (limb.mirrored) from_hip.linear().row(1) *= -1.0;  // in the axes of the limb as given
    OutlineHulls out = outline_hulls(assembly.trunk, from_hip);
    for (const OutlineHull& hull :
         outline_hulls(with_cradle(own.servo), servo_pose(own, towards_above(limb, 0))))
      out.push_back(hull);
    return out;
  }
  return moved(parts_at(hulls_of_link(assembly, limb, joint - 1).hulls, own.offset),
               Eigen::Isometry3d(Eigen::Translation3d(-own.offset)));
}

}  // namespace

PrintedLink::PrintedLink(const Assembly& assembly, const PlacedLimb& limb, std::size_t joint)
    : ends_(link_ends(limb, joint)),
      radius_(assembly.link_radius),
      hulls_(hulls_of_link(assembly, limb, joint).hulls),
      clearance_(assembly.link_clearance - kKeptByLinks) {
  find_what_is_near(carrier_of(assembly, limb, joint));
  const double room = assembly.print->bed.minCoeff();
  fits_ = span(1.0) <= room;
  most_span_ = std::max(room, span(1.0));
}

bool PrintedLink::is_allowed(double scale) const {
  if (span(scale) > most_span_) return false;
  const OutlineHulls other = other_at(scale), parts = printed_at(scale);
  const auto all_clear = [](const std::vector<Near>& near, const OutlineHulls& of) {
    return std::all_of(near.begin(), near.end(), [&](const Near& each) {
      return hull_distance({each.hull}, of) >= each.least;
    });
  };
  return all_clear(of_other_, other) && all_clear(of_parts_, parts);
}

// At the angles at which the module at the far end is clear of the servo as drawn; where that is
// nowhere so, at those at which it is farthest.
void PrintedLink::find_what_is_near(const OutlineHulls& carrier) {
  const OutlineHulls other = other_at(1.0), parts = printed_at(1.0);
  std::array<double, kSampledAngles> drawn{};
  for (int k = 0; k < kSampledAngles; ++k)
    drawn[k] = hull_distance(servo_seen_from_link(ends_, k), other);
  const double own =
      std::min(clearance_, *std::max_element(drawn.begin(), drawn.end()) - kKeptByLinks);
  for (int k = 0; k < kSampledAngles; ++k) {
    if (drawn[k] < own) continue;  // it cannot be there as drawn
    const OutlineHulls servo = servo_seen_from_link(ends_, k);
    for (const OutlineHull& hull : servo) {
      of_other_.push_back({hull, own});
      if (hull_distance({hull}, parts) >= clearance_) of_parts_.push_back({hull, clearance_});
    }
    for (const OutlineHull& hull : moved(carrier, turn_to_link(ends_, k))) {
      if (hull_distance({hull}, other) >= clearance_) of_other_.push_back({hull, clearance_});
      if (hull_distance({hull}, parts) >= clearance_) of_parts_.push_back({hull, clearance_});
    }
  }
}

Vector3d PrintedLink::place_at(double scale) const {
  return ends_.place + (scale - 1.0) * (ends_.place + end_of_length(ends_));
}

OutlineHulls PrintedLink::other_at(double scale) const {
  LinkEnds ends = ends_;
  ends.place = place_at(scale);
  return other_end_of_link(ends);
}

OutlineHulls PrintedLink::printed_at(double scale) const {
  const Vector3d place = place_at(scale);
  if (hulls_.empty()) return {{{Vector3d::Zero(), place}, radius_}};
  return parts_at(hulls_, place);
}

double PrintedLink::span(double scale) const {
  OutlineHulls hulls = printed_at(scale);
  if (ends_.other->kind == ModuleKind::foot) {
    const OutlineShape& ball = ends_.other->outline.front();
    hulls.push_back({{place_at(scale) + ball.position}, kPeg * ball.size.x()});
  }
  double most = 0.0;
  for (const OutlineHull& one : hulls)
    for (const OutlineHull& other : hulls)
      for (const Vector3d& a : one.points)
        for (const Vector3d& b : other.points)
          most = std::max(most, (a - b).norm() + one.radius + other.radius);
  return most;
}

}  // namespace legwright
