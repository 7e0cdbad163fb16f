// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/printed_link.hpp"

#include <algorithm>
#include <array>

#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/assembly/link_sizes.hpp"
#include "mjcf/assembly/printed_trunk.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kKeptByLinks = 1e-9;  // [m], of distances that stay as they are
constexpr double kPeg = 0.3;           // radius of the peg that holds a ball foot, of the ball's

/// Where a link's length is measured to, from its place there: a foot's middle, or the next joint.
Vector3d end_of_length(const LinkEnds& ends) {
  return ends.other->kind == ModuleKind::foot ? ends.other->outline.front().position
                                              : Vector3d(Vector3d::Zero());
}

}  // namespace

PrintedLink::PrintedLink(const Assembly& assembly, const PlacedLimb& limb, std::size_t joint)
    : ends_(link_ends(limb, joint)),
      radius_(link_radius(assembly)),
      hulls_(hulls_of_link(assembly, limb, joint).hulls),
      clearance_(assembly.link_clearance - kKeptByLinks) {
  find_what_is_near(carrier_of(assembly, limb, joint));
  const double room = assembly.print->room().minCoeff();
  fits_ = span(1.0, {}) <= room;
  most_span_ = std::max(room, span(1.0, {}));
}

std::vector<PrintedLink::Seen> PrintedLink::carrier_of(const Assembly& assembly,
                                                       const PlacedLimb& limb, std::size_t joint) {
  const AssemblyJoint& own = limb.of->joints[joint];
  std::vector<Seen> out;
  if (joint > 0) {
    for (const LinkHull& hull : hulls_of_link(assembly, limb, joint - 1).hulls) {
      out.push_back({{{}, 0.0}, hull.far});
      for (const Vector3d& point : hull.near)
        out.back().still.points.emplace_back(point - own.offset);
    }
    return out;
  }
  Eigen::Isometry3d from_hip(Eigen::Translation3d(-limb.vector(limb.hip)));
  if (limb.mirrored) from_hip.linear().row(1) *= -1.0;  // in the axes of the limb as given
  for (const OutlineHull& hull : outline_hulls(assembly.trunk, from_hip)) out.push_back({hull, {}});
  for (const OutlineHull& hull :
       outline_hulls(with_cradle(own.servo), servo_pose(own, towards_above(limb, 0))))
    out.push_back({{{}, hull.radius}, hull.points});
  return out;
}

bool PrintedLink::is_allowed(double scale, const LinkTurns& turns) const {
  if (span(scale, turns) > most_span_) return false;
  const OutlineHulls other = other_at(scale, turns), parts = printed_at(scale, turns);
  const auto all_clear = [&](const std::vector<Near>& near, const OutlineHulls& of) {
    return std::all_of(near.begin(), near.end(), [&](const Near& each) {
      return hull_distance({hull_of(each.what, turns.own)}, of) >= each.least;
    });
  };
  return all_clear(of_other_, other) && all_clear(of_parts_, parts);
}

OutlineHull PrintedLink::hull_of(const Seen& seen, const Eigen::Matrix3d& turn) const {
  LinkEnds ends = ends_;
  ends.axis = turn * ends.axis;
  const Eigen::Isometry3d to_link = turn_to_link(ends, seen.sample);
  OutlineHull out{{}, seen.still.radius};
  for (const Vector3d& point : seen.still.points) out.points.emplace_back(to_link * point);
  for (const Vector3d& point : seen.turning) out.points.emplace_back(to_link * (turn * point));
  return out;
}

// At the angles at which the module at the far end is clear of the servo as drawn; where that is
// nowhere so, at those at which it is farthest.
void PrintedLink::find_what_is_near(const std::vector<Seen>& carrier) {
  const OutlineHulls other = other_at(1.0, {}), parts = printed_at(1.0, {});
  std::array<double, kSampledAngles> drawn{};
  for (int k = 0; k < kSampledAngles; ++k)
    drawn[k] = hull_distance(servo_seen_from_link(ends_, k), other);
  const double own =
      std::min(clearance_, *std::max_element(drawn.begin(), drawn.end()) - kKeptByLinks);
  for (int k = 0; k < kSampledAngles; ++k) {
    if (drawn[k] < own) continue;  // it cannot be there as drawn
    for (const OutlineHull& hull : outline_hulls(*ends_.servo, ends_.servo_pose)) {
      const Seen seen{{{}, hull.radius}, hull.points, k};
      of_other_.push_back({seen, own});
      if (hull_distance({hull_of(seen, Eigen::Matrix3d::Identity())}, parts) >= clearance_)
        of_parts_.push_back({seen, clearance_});
    }
    for (Seen seen : carrier) {
      seen.sample = k;
      const OutlineHulls hull{hull_of(seen, Eigen::Matrix3d::Identity())};
      if (hull_distance(hull, other) >= clearance_) of_other_.push_back({seen, clearance_});
      if (hull_distance(hull, parts) >= clearance_) of_parts_.push_back({seen, clearance_});
    }
  }
}

Vector3d PrintedLink::place_at(double scale) const {
  return ends_.place + (scale - 1.0) * (ends_.place + end_of_length(ends_));
}

OutlineHulls PrintedLink::other_at(double scale, const LinkTurns& turns) const {
  LinkEnds ends = ends_;
  ends.place = place_at(scale);
  ends.other_pose = Eigen::Isometry3d(turns.next) * ends.other_pose;
  return other_end_of_link(ends);
}

OutlineHulls PrintedLink::printed_at(double scale, const LinkTurns& turns) const {
  const Vector3d place = place_at(scale);
  if (hulls_.empty()) return {{{Vector3d::Zero(), place}, radius_}};
  OutlineHulls out;
  for (const LinkHull& hull : hulls_) {
    out.push_back({});
    for (const Vector3d& point : hull.near) out.back().points.emplace_back(turns.own * point);
    for (const Vector3d& point : hull.far)
      out.back().points.emplace_back(place + turns.next * point);
  }
  return out;
}

double PrintedLink::span(double scale, const LinkTurns& turns) const {
  OutlineHulls hulls = printed_at(scale, turns);
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
