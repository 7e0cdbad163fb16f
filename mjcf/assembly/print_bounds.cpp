// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/print_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string_view>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/assembly/outline_hulls.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kKept = 1e-9;  // [m], of distances that stay as they are
// [m] around servos on the trunk: `legwright parts` takes its --fit and twice its --wall there.
constexpr double kCradle = 0.3e-3 + 2.0 * 1.2e-3;
constexpr double kPeg = 0.3;          // radius of the peg that holds a ball foot, of the ball's
constexpr double kPerGrain = 1e6;     // bounds are written to a millionth of a metre
constexpr double kLeastRange = 1e-3;  // of a length, below which it is left out
constexpr int kScaleSteps = 8, kScaleHalvings = 13;  // to a bound: those of 0.25 to 1e-5

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

/// Where a link's length is measured to, from its place there: a foot's middle, or the next joint.
Vector3d end_of_length(const LinkEnds& ends) {
  return ends.other->kind == ModuleKind::foot ? ends.other->outline.front().position
                                              : Vector3d(Vector3d::Zero());
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
        radius_(assembly.link_radius),
        hulls_(link_hulls(ends_, radius_, assembly.link_wall, assembly.link_clearance).hulls),
        clearance_(assembly.link_clearance - kKept) {
    find_what_is_near(carrier_of(assembly, limb, joint));
    const double room = assembly.print->bed.minCoeff();
    fits_ = span(1.0) <= room;
    most_span_ = std::max(room, span(1.0));
  }

  bool is_allowed(double scale) const {
    if (span(scale) > most_span_) return false;
    const OutlineHulls other = other_at(scale), parts = printed_at(scale);
    const auto all_clear = [](const std::vector<Near>& near, const OutlineHulls& of) {
      return std::all_of(near.begin(), near.end(), [&](const Near& each) {
        return hull_distance({each.hull}, of) >= each.least;
      });
    };
    return all_clear(of_other_, other) && all_clear(of_parts_, parts);
  }

  /// Whether its part lies on the bed as drawn.
  bool fits() const { return fits_; }

 private:
  /// What stays at least so far away [m].
  struct Near {
    OutlineHull hull;
    double least;
  };

  /// At the angles at which the module at the far end is clear of the servo as drawn; where that is
  /// nowhere so, at those at which it is farthest.
  void find_what_is_near(const OutlineHulls& carrier) {
    const OutlineHulls other = other_at(1.0), parts = printed_at(1.0);
    std::array<double, kSampledAngles> drawn{};
    for (int k = 0; k < kSampledAngles; ++k)
      drawn[k] = hull_distance(servo_seen_from_link(ends_, k), other);
    const double own = std::min(clearance_, *std::max_element(drawn.begin(), drawn.end()) - kKept);
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

  /// The place at the far end in a link of that scale.
  Vector3d place_at(double scale) const {
    return ends_.place + (scale - 1.0) * (ends_.place + end_of_length(ends_));
  }

  OutlineHulls other_at(double scale) const {
    LinkEnds ends = ends_;
    ends.place = place_at(scale);
    return other_end_of_link(ends);
  }

  /// The hulls; a capsule where there are none.
  OutlineHulls printed_at(double scale) const {
    const Vector3d place = place_at(scale);
    if (hulls_.empty()) return {{{Vector3d::Zero(), place}, radius_}};
    return parts_at(hulls_, place);
  }

  /// The largest distance of two points of the part, with a peg to the middle of a ball foot [m].
  double span(double scale) const {
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

  LinkEnds ends_;
  double radius_;  // of a capsule [m]
  std::vector<LinkHull> hulls_;
  double clearance_;                       // [m]
  std::vector<Near> of_other_, of_parts_;  // of the module there, and of the part
  bool fits_ = true;
  double most_span_ = 0.0;  // [m]
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
    drawn_size_ = size_at(Vector3d::Ones());
    for (const auto& [i, j] : pairs()) drawn_.push_back(distance(i, j, Vector3d::Ones()));
  }

  bool is_allowed(const Vector3d& scale) const {
    const Vector3d size = size_at(scale);
    const bool has_not_grown =
        size.x() <= drawn_size_.x() + kKept && size.y() <= drawn_size_.y() + kKept;
    if (!has_not_grown && !lies_on_bed(size)) return false;
    std::size_t k = 0;
    for (const auto& [i, j] : pairs())
      if (distance(i, j, scale) < std::min(clearance_, drawn_[k++] - kKept)) return false;
    return true;
  }

  bool fits() const { return lies_on_bed(drawn_size_); }

 private:
  struct Rider {
    Vector3d place;  // of its body [m]
    OutlineHulls outline, cradle;
  };

  bool lies_on_bed(const Vector3d& size) const {
    return (size.x() <= bed_.x() && size.y() <= bed_.y()) ||
           (size.x() <= bed_.y() && size.y() <= bed_.x());
  }

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

  Eigen::Vector2d bed_;  // [m]
  Vector3d drawn_size_;  // of the tray [m]
  double clearance_;
  Vector3d low_, high_;  // of its box [m]
  std::vector<Rider> riders_;
  std::vector<double> drawn_;  // distances of pairs() [m]
};

/// The links that a binding stretches, "stretch link: FL_thigh 0.98*FR_thigh", all in proportion;
/// none of another binding.
std::vector<std::string> stretched_links(const std::string& binding) {
  constexpr std::string_view kHead = "stretch link: ";
  std::vector<std::string> out;
  if (!binding.starts_with(kHead)) return out;
  std::istringstream in(binding.substr(kHead.size()));
  for (std::string word; in >> word;) out.push_back(word.substr(word.find('*') + 1));
  return out;
}

class BoundsOfPrint {
 public:
  explicit BoundsOfPrint(const Assembly& assembly) : assembly_(assembly), trunk_(assembly) {
    if (!trunk_.fits()) too_large_.emplace_back("the trunk");
  }

  PrintBounds run(const std::vector<Proposal>& proposals) {
    for (const Proposal& proposal : proposals) {
      const std::vector<std::string> links = stretched_links(proposal.binding);
      if (proposal.binding.starts_with("axis "))
        out_.left_out.push_back(proposal.name + ": " + kAxesStay);
      else if (proposal.binding == "stretch x: trunk")
        length_ = narrow(proposal, [&](double k) { return trunk_.is_allowed({k, width_, 1.0}); });
      else if (proposal.binding == "stretch y: trunk")
        width_ = narrow(proposal, [&](double k) { return trunk_.is_allowed({length_, k, 1.0}); });
      else if (!links.empty())
        narrow_link(proposal, links);
      else
        out_.proposals.push_back(proposal);
    }
    write_notes();
    return out_;
  }

 private:
  void write_notes() {
    if (out_.left_out.size() > without_room_.size())
      out_.notes.push_back(std::string("axes of joints are no design parameters: ") + kAxesStay);
    if (!without_room_.empty())
      out_.notes.push_back(
          fmt::format("no design parameters, as clearance and bed leave no room: {}",
                      fmt::join(without_room_, ", ")));
    if (!too_large_.empty())
      out_.notes.push_back(
          fmt::format("larger than the bed as drawn, which [print] bed gives, and no design is "
                      "larger still: {}",
                      fmt::join(too_large_, ", ")));
    if (!narrowed_.empty())
      out_.notes.push_back(fmt::format(
          "what is printed narrows bounds, by the clearance of {:.3g} mm and the bed: {}",
          1e3 * assembly_.link_clearance, fmt::join(narrowed_, ", ")));
  }

  void narrow_link(const Proposal& proposal, const std::vector<std::string>& names) {
    std::vector<PrintedLink> links;
    for (const PlacedLimb& limb : placed_limbs(assembly_))
      for (std::size_t k = 0; k < limb.of->joints.size(); ++k) {
        const std::string name = link_name(limb, limb.of->joints[k]);
        if (std::find(names.begin(), names.end(), name) == names.end()) continue;
        links.emplace_back(assembly_, limb, k);
        if (!links.back().fits()) too_large_.push_back(name);
      }
    narrow(proposal, [&](double scale) {
      return std::all_of(links.begin(), links.end(),
                         [&](const PrintedLink& link) { return link.is_allowed(scale); });
    });
  }

  /// @return the least scale of the length
  double narrow(const Proposal& proposal, const std::function<bool(double)>& is_allowed) {
    const double low = farthest_scale(proposal.lower / proposal.value, is_allowed),
                 high = farthest_scale(proposal.upper / proposal.value, is_allowed);
    // Inwards to a millionth of a metre, as far as there is room.
    Proposal out = proposal;
    if (low > proposal.lower / proposal.value)
      out.lower = std::min(out.value, std::ceil(low * out.value * kPerGrain) / kPerGrain);
    if (high < proposal.upper / proposal.value)
      out.upper = std::max(out.value, std::floor(high * out.value * kPerGrain) / kPerGrain);
    if (out.upper - out.lower < kLeastRange * out.value) {
      out_.left_out.push_back(out.name + ": clearance and bed leave its parts no room to change");
      without_room_.push_back(out.name);
      return 1.0;
    }
    if (out.lower > proposal.lower || out.upper < proposal.upper)
      narrowed_.push_back(fmt::format("{} {:.4g} to {:.4g} m", out.name, out.lower, out.upper));
    out_.proposals.push_back(out);
    return out.lower / out.value;
  }

  const Assembly& assembly_;
  const PrintedTrunk trunk_;
  double length_ = 1.0, width_ = 1.0;  // of the trunk, at which the other is looked at
  std::vector<std::string> narrowed_, without_room_, too_large_;
  PrintBounds out_;
};

}  // namespace

PrintBounds print_bounds(const Assembly& assembly, const std::vector<Proposal>& proposals) {
  return BoundsOfPrint(assembly).run(proposals);
}
}  // namespace legwright
