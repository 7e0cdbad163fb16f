// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/print_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <sstream>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/assembly/outline_hulls.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kKept = 1e-9;        // [m], of distances that stay as they are
constexpr double kCradle = 2.7e-3;    // [m] around servos on the trunk: fit and walls of parts
constexpr double kPerGrain = 1e6;     // bounds are written to a millionth of a metre
constexpr double kLeastRange = 1e-3;  // of a length, below which it is left out
constexpr int kScaleSteps = 8, kScaleHalvings = 12;  // to a bound: those of 0.25 to 1e-5

constexpr const char* kAxesStay =
    "the parts are to be printed, and a servo keeps its direction when its axis turns, so that the "
    "next part would not lie on its horn";

/// The scale farthest from 1 towards `to` up to which all is allowed that is at 1.
double farthest_scale(double to, const std::function<bool(double)>& is_allowed) {
  double good = 1.0, bad = to;
  int step = 1;
  for (; step <= kScaleSteps; ++step) {
    bad = 1.0 + (to - 1.0) * step / kScaleSteps;
    if (!is_allowed(bad)) break;
    good = bad;
  }
  if (step > kScaleSteps) return to;
  for (int k = 0; k < kScaleHalvings; ++k) {
    const double middle = 0.5 * (good + bad);
    (is_allowed(middle) ? good : bad) = middle;
  }
  return good;
}

OutlineHulls moved(OutlineHulls hulls, const Eigen::Isometry3d& by) {
  for (OutlineHull& hull : hulls)
    for (Vector3d& point : hull.points) point = by * point;
  return hulls;
}

/// Printed parts, the points at whose far end are from `place`.
OutlineHulls parts_at(const std::vector<LinkHull>& hulls, const Vector3d& place) {
  OutlineHulls out;
  for (const LinkHull& hull : hulls) {
    out.push_back({hull.near, 0.0});
    for (const Vector3d& point : hull.far) out.back().points.emplace_back(place + point);
  }
  return out;
}

/// A servo and the walls around it on the trunk.
Module with_cradle(Module servo) {
  for (OutlineShape& shape : servo.outline) {
    const bool is_box = shape.type == OutlineShape::Type::box;
    shape.size += Vector3d(is_box ? 2.0 : 1.0, 2.0, is_box ? 2.0 : 0.0) * kCradle;
  }
  return servo;
}

/// What carries a link's servo, from the joint there: the trunk with the servo's cradle, or the
/// parts of the link above.
OutlineHulls carrier_of(const Assembly& assembly, const PlacedLimb& limb, std::size_t joint) {
  const AssemblyJoint& own = limb.of->joints[joint];
  if (joint == 0) {
    Eigen::Isometry3d from_hip(Eigen::Translation3d(-limb.vector(limb.hip)));
    if (limb.mirrored) from_hip.linear().row(1) *= -1.0;  // a trunk's outline mirrors itself
    OutlineHulls out = outline_hulls(assembly.trunk, from_hip);
    for (const OutlineHull& hull :
         outline_hulls(with_cradle(own.servo), servo_pose(own, towards_above(limb, 0))))
      out.push_back(hull);
    return out;
  }
  const LinkHulls above = link_hulls(link_ends(limb, joint - 1), assembly.link_radius,
                                     assembly.link_wall, assembly.link_clearance);
  return moved(parts_at(above.hulls, own.offset),
               Eigen::Isometry3d(Eigen::Translation3d(-own.offset)));
}

/// What a link's length changes: the module at its far end, and the hulls that reach it. Both keep
/// clear of the servo that turns the link, and of what carries that, where they are as drawn.
class PrintedLink {
 public:
  PrintedLink(const Assembly& assembly, const PlacedLimb& limb, std::size_t joint)
      : ends_(link_ends(limb, joint)),
        hulls_(link_hulls(ends_, assembly.link_radius, assembly.link_wall, assembly.link_clearance)
                   .hulls),
        clearance_(assembly.link_clearance - kKept) {
    const OutlineHulls carrier = carrier_of(assembly, limb, joint), other = other_at(1.0),
                       parts = parts_at(hulls_, ends_.place);
    for (int k = 0; k < kSampledAngles; ++k) {
      OutlineHulls near = servo_seen_from_link(ends_, k);
      if (hull_distance(near, other) < clearance_) continue;  // it cannot be there as drawn
      for (OutlineHull& hull : moved(carrier, turn_to_link(ends_, k))) near.push_back(hull);
      for (const OutlineHull& each : near) {
        if (is_clear(each, other)) of_other_.push_back(each);
        if (is_clear(each, parts)) of_parts_.push_back(each);
      }
    }
    room_ = std::max(assembly.print->bed.head<2>().minCoeff(), span(1.0));
  }

  bool is_allowed(double scale) const {
    if (span(scale) > room_) return false;
    const OutlineHulls other = other_at(scale), parts = parts_at(hulls_, scale * ends_.place);
    const auto all_clear = [&](const OutlineHulls& near, const OutlineHulls& of) {
      return std::all_of(near.begin(), near.end(),
                         [&](const OutlineHull& each) { return is_clear(each, of); });
    };
    return all_clear(of_other_, other) && all_clear(of_parts_, parts);
  }

 private:
  bool is_clear(const OutlineHull& near, const OutlineHulls& of) const {
    return hull_distance({near}, of) >= clearance_;
  }

  OutlineHulls other_at(double scale) const {
    LinkEnds ends = ends_;
    ends.place *= scale;
    return other_end_of_link(ends);
  }

  /// The largest distance of two points of the part [m].
  double span(double scale) const {
    std::vector<Vector3d> points;
    for (const OutlineHull& hull : parts_at(hulls_, scale * ends_.place))
      points.insert(points.end(), hull.points.begin(), hull.points.end());
    double most = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) most = std::max(most, (points[i] - points[j]).norm());
    return most;
  }

  LinkEnds ends_;
  std::vector<LinkHull> hulls_;
  double clearance_;                  // [m]
  OutlineHulls of_other_, of_parts_;  // what the module and the parts keep clear of
  double room_ = 0.0;                 // [m]
};

/// What length and width of the trunk change: the modules on it, which move with their places.
class PrintedTrunk {
 public:
  explicit PrintedTrunk(const Assembly& assembly)
      : bed_(assembly.print->bed), clearance_(assembly.link_clearance - kKept) {
    const ModuleExtent box = extent_of(assembly.trunk);
    low_ = box.middle - box.half;
    high_ = box.middle + box.half;
    for (const AssemblyPart& part : assembly.parts) {
      const Eigen::Isometry3d pose(Eigen::Translation3d(part.position));
      riders_.push_back({part.position, outline_hulls(part.module, pose), {}});
    }
    for (const PlacedLimb& limb : placed_limbs(assembly)) {
      const AssemblyJoint& hip = limb.of->joints.front();
      const auto on_trunk = [&](const Module& servo) {
        OutlineHulls out = outline_hulls(servo, servo_pose(hip, towards_above(limb, 0)));
        for (OutlineHull& hull : out)
          for (Vector3d& point : hull.points) point = limb.hip + limb.vector(point);
        return out;
      };
      riders_.push_back({limb.hip, on_trunk(hip.servo), on_trunk(with_cradle(hip.servo))});
    }
    const Vector3d size = size_at(Vector3d::Ones());
    if (size.x() > bed_.x() || size.y() > bed_.y()) std::swap(bed_.x(), bed_.y());
    bed_ = bed_.cwiseMax(size);
    for (const auto& [i, j] : pairs()) drawn_.push_back(distance(i, j, Vector3d::Ones()));
  }

  bool is_allowed(const Vector3d& scale) const {
    const Vector3d size = size_at(scale);
    if (size.x() > bed_.x() + kKept || size.y() > bed_.y() + kKept) return false;
    std::size_t k = 0;
    for (const auto& [i, j] : pairs())
      if (distance(i, j, scale) < std::min(clearance_, drawn_[k++] - kKept)) return false;
    return true;
  }

 private:
  struct Rider {
    Vector3d place;  // of its body [m]
    OutlineHulls outline, cradle;
  };

  std::vector<std::pair<std::size_t, std::size_t>> pairs() const {
    std::vector<std::pair<std::size_t, std::size_t>> out;
    for (std::size_t i = 0; i < riders_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) out.emplace_back(i, j);
    return out;
  }

  /// What of a rider it is, where a scale takes it.
  static OutlineHulls at(const OutlineHulls& of, const Rider& rider, const Vector3d& scale) {
    const Vector3d by = (scale - Vector3d::Ones()).cwiseProduct(rider.place);
    return moved(of, Eigen::Isometry3d(Eigen::Translation3d(by)));
  }

  double distance(std::size_t i, std::size_t j, const Vector3d& scale) const {
    return hull_distance(at(riders_[i].outline, riders_[i], scale),
                         at(riders_[j].outline, riders_[j], scale));
  }

  /// Of the tray with its cradles, along the axes [m].
  Vector3d size_at(const Vector3d& scale) const {
    Vector3d low = low_.cwiseProduct(scale), high = high_.cwiseProduct(scale);
    for (const Rider& rider : riders_)
      for (const OutlineHull& hull : at(rider.cradle, rider, scale))
        for (const Vector3d& point : hull.points) {
          low = low.cwiseMin(point - Vector3d::Constant(hull.radius));
          high = high.cwiseMax(point + Vector3d::Constant(hull.radius));
        }
    return high - low;
  }

  Vector3d bed_;  // as the trunk lies on it, and at least as large as that is drawn [m]
  double clearance_;
  Vector3d low_, high_;  // of its box [m]
  std::vector<Rider> riders_;
  std::vector<double> drawn_;  // distances of pairs() [m]
};

std::vector<std::string> words_behind(const std::string& text, const std::string& head) {
  std::vector<std::string> out;
  if (!text.starts_with(head)) return out;
  std::istringstream in(text.substr(head.size()));
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

class Bounds {
 public:
  explicit Bounds(const Assembly& assembly) : assembly_(assembly), trunk_(assembly) {}

  PrintBounds run(const std::vector<Proposal>& proposals) {
    for (const Proposal& proposal : proposals) {
      if (proposal.binding.starts_with("axis "))
        out_.left_out.push_back(proposal.name + ": " + kAxesStay);
      else if (proposal.binding.starts_with("stretch x: "))
        narrow(proposal, [&](double scale) { return trunk_.is_allowed({scale, width_, 1.0}); });
      else if (proposal.binding.starts_with("stretch y: "))
        narrow(proposal, [&](double scale) { return trunk_.is_allowed({length_, scale, 1.0}); });
      else
        narrow_link(proposal);
    }
    if (out_.left_out.size() > stays_.size())
      out_.notes.push_back(std::string("axes of joints are no design parameters: ") + kAxesStay);
    if (!stays_.empty())
      out_.notes.push_back(
          fmt::format("clearance and bed leave no room for another {}", fmt::join(stays_, ", ")));
    if (!narrowed_.empty())
      out_.notes.push_back(fmt::format(
          "what is printed narrows bounds, by the clearance of {:.3g} mm and the bed: {}",
          1e3 * assembly_.link_clearance, fmt::join(narrowed_, ", ")));
    return out_;
  }

 private:
  void narrow_link(const Proposal& proposal) {
    const std::vector<std::string> names = words_behind(proposal.binding, "stretch link: ");
    std::vector<PrintedLink> links;
    std::set<std::pair<const AssemblyLimb*, std::size_t>> seen;  // mirror images are alike
    for (const PlacedLimb& limb : placed_limbs(assembly_))
      for (std::size_t k = 0; k < limb.of->joints.size(); ++k) {
        const std::string name = link_name(limb, limb.of->joints[k]);
        if (std::find(names.begin(), names.end(), name) != names.end() &&
            (seen.emplace(limb.of, k).second || !limb.mirrored))
          links.emplace_back(assembly_, limb, k);
      }
    narrow(proposal, [&](double scale) {
      return std::all_of(links.begin(), links.end(),
                         [&](const PrintedLink& link) { return link.is_allowed(scale); });
    });
  }

  void narrow(const Proposal& proposal, const std::function<bool(double)>& is_allowed) {
    const double low = farthest_scale(proposal.lower / proposal.value, is_allowed),
                 high = farthest_scale(proposal.upper / proposal.value, is_allowed);
    // Inwards to a millionth of a metre, as far as there is room.
    Proposal out = proposal;
    if (low > proposal.lower / proposal.value)
      out.lower = std::min(out.value, std::ceil(low * out.value * kPerGrain) / kPerGrain);
    if (high < proposal.upper / proposal.value)
      out.upper = std::max(out.value, std::floor(high * out.value * kPerGrain) / kPerGrain);
    if (out.upper - out.lower < kLeastRange * out.value) {
      out_.left_out.push_back(
          out.name + ": clearance and bed leave no room for another one of what is printed");
      stays_.push_back(out.name);
      return;
    }
    if (out.lower > proposal.lower || out.upper < proposal.upper)
      narrowed_.push_back(fmt::format("{} {:.4g} to {:.4g} m", out.name, out.lower, out.upper));
    if (proposal.binding.starts_with("stretch x: ")) length_ = out.lower / out.value;
    out_.proposals.push_back(out);
  }

  const Assembly& assembly_;
  const PrintedTrunk trunk_;
  double length_ = 1.0, width_ = 1.0;  // of the trunk, at which the other is looked at
  std::vector<std::string> narrowed_, stays_;
  PrintBounds out_;
};

}  // namespace

PrintBounds print_bounds(const Assembly& assembly, const std::vector<Proposal>& proposals) {
  return Bounds(assembly).run(proposals);
}
}  // namespace legwright
