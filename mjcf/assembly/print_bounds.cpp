// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/print_bounds.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/assembly/printed_link.hpp"
#include "mjcf/assembly/printed_trunk.hpp"
#include "mjcf/read/mirror.hpp"
#include "mjcf/read/printed_robot.hpp"

namespace legwright {
namespace {

constexpr double kPerGrain = 1e6;     // bounds are written to a millionth of a metre
constexpr double kPerAngle = 1e3;     // and to a thousandth of a radian
constexpr double kLeastRange = 1e-3;  // of a length, below which it is left out
constexpr double kLeastTurn = 0.02;   // [rad], likewise
const Eigen::Vector3d kAsDrawn = Eigen::Vector3d::Ones();  // scales of the trunk
constexpr double kHalfTurn = std::numbers::pi;             // [rad]
constexpr int kSteps = 8;                                  // to a bound
constexpr int kScaleHalvings = 13;  // of a length, from there on: those of 0.25 to 1e-5
constexpr int kTurnHalvings = 6;    // of an angle: those of 1 to 2e-3

/// The value farthest from `from` towards `to` up to which all is allowed that is at `from`.
double farthest(double from, double to, int halvings,
                const std::function<bool(double)>& is_allowed) {
  double good = from, bad = to;
  int step = 1;
  for (; step <= kSteps; ++step) {
    bad = from + (to - from) * step / kSteps;
    if (!is_allowed(bad)) break;
    good = bad;
  }
  if (step > kSteps) return to;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (good + bad);
    (is_allowed(middle) ? good : bad) = middle;
  }
  return good;
}

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

bool stretches_trunk(const std::string& binding) {
  return binding == "stretch x: trunk" || binding == "stretch y: trunk";
}

/// What a binding turns, "axis z: FL_hip ~FR_hip": of each joint about what, in the trunk's axes.
using TurnedAxes = std::map<std::string, Eigen::Vector3d>;

/// Of a binding that turns axes; no joints of another.
TurnedAxes turned_axes(const std::string& binding) {
  constexpr std::string_view kHead = "axis ";
  TurnedAxes out;
  if (!binding.starts_with(kHead) || binding.size() < kHead.size() + 3) return out;
  const Eigen::Vector3d about = Eigen::Vector3d::Unit(binding[kHead.size()] - 'x');
  std::istringstream in(binding.substr(kHead.size() + 2));
  for (std::string word; in >> word;) {
    const std::string name = word.substr(word.find('*') + 1);
    const bool across_y = name.front() == '~', across_x = name.front() == '^';
    if (across_y || across_x)
      out.emplace(name.substr(1), turn_in_mirror(about, across_y ? Across::y : Across::x));
    else
      out.emplace(name, about);
  }
  return out;
}

class BoundsOfPrint {
 public:
  explicit BoundsOfPrint(const Assembly& assembly)
      : assembly_(assembly), limbs_(placed_limbs(assembly)), trunk_(assembly) {
    if (!trunk_.fits()) too_large_.emplace_back("the trunk");
  }

  PrintBounds run(const std::vector<Proposal>& proposals) {
    std::vector<std::optional<Proposal>> found(proposals.size());
    for (std::size_t k = 0; k < proposals.size(); ++k) found[k] = narrowed(proposals[k]);
    narrow_hips(found);
    for (std::size_t k = 0; k < proposals.size(); ++k) {
      if (found[k] && stretches_trunk(proposals[k].binding)) found[k] = narrow_trunk(*found[k]);
      if (!found[k]) {
        leave_out(proposals[k].name);
        continue;
      }
      tell(as_far_as_asked(proposals[k]), *found[k]);
      out_.proposals.push_back(*found[k]);
    }
    write_notes();
    return out_;
  }

 private:
  void write_notes() {
    if (assembly_.print->turn == 0.0)
      out_.notes.push_back(std::string("axes of joints are no design parameters: ") + kAxesStay);
    if (!without_room_.empty())
      out_.notes.push_back(
          fmt::format("no design parameters, as clearance and bed leave no room: {}",
                      fmt::join(without_room_, ", ")));
    if (!boundless_.empty())
      out_.notes.push_back(
          fmt::format("what is printed keeps clear at all angles of a joint, which leaves its axis "
                      "little room to turn: give it a `range` no larger than it needs: {}",
                      fmt::join(boundless_, ", ")));
    if (!too_large_.empty())
      out_.notes.push_back(fmt::format(
          "larger than the bed as drawn, less {:.3g} mm at each side of it ([print] bed, "
          "margin), and no design is larger still: {}",
          1e3 * assembly_.print->margin, fmt::join(too_large_, ", ")));
    if (!narrowed_.empty())
      out_.notes.push_back(fmt::format(
          "what is printed narrows bounds, by the clearance of {:.3g} mm and the bed: {}",
          1e3 * assembly_.link_clearance, fmt::join(narrowed_, ", ")));
  }

  /// The link of a joint, looked at once.
  const PrintedLink& link_of(const PlacedLimb& limb, std::size_t joint) {
    const std::string name = link_name(limb, limb.of->joints[joint]);
    return links_.try_emplace(name, assembly_, limb, joint).first->second;
  }

  /// A proposal by itself; nothing where there is no room. Those of the trunk come later.
  std::optional<Proposal> narrowed(const Proposal& proposal) {
    const std::vector<std::string> links = stretched_links(proposal.binding);
    if (!links.empty()) return narrow_link(proposal, links);
    const TurnedAxes axes = turned_axes(proposal.binding);
    return axes.empty() ? proposal : narrow_turn(as_far_as_asked(proposal), axes);
  }

  /// A turn within `[print] turn`; other proposals as they are.
  Proposal as_far_as_asked(const Proposal& proposal) const {
    Proposal out = proposal;
    if (turned_axes(proposal.binding).empty()) return out;
    out.lower = std::max(out.lower, -assembly_.print->turn);
    out.upper = std::min(out.upper, assembly_.print->turn);
    return out;
  }

  /// A link, and about what one of its ends is turned, in the axes of the limb as the file gives
  /// it.
  struct TurnedLink {
    const PrintedLink* link;
    bool is_far_end;
    Eigen::Vector3d about;

    bool is_allowed(double angle) const {
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, about).toRotationMatrix();
      LinkTurns turns;
      (is_far_end ? turns.next : turns.own) = turn;
      return link->is_allowed(1.0, turns);
    }
  };

  std::optional<Proposal> narrow_turn(const Proposal& proposal, const TurnedAxes& axes) {
    HipTurn hips;
    std::vector<TurnedLink> links;
    for (const PlacedLimb& limb : limbs_)
      for (std::size_t k = 0; k < limb.of->joints.size(); ++k) {
        const auto axis = axes.find(joint_name(limb, limb.of->joints[k]));
        if (axis == axes.end()) continue;
        const Eigen::Vector3d about = limb.hinge(axis->second);
        links.push_back({&link_of(limb, k), false, about});
        if (k > 0) links.push_back({&link_of(limb, k - 1), true, about});
        if (k == 0) hips.about.emplace(limb.name, axis->second);
      }
    const auto is_allowed = [&](double angle) {
      hips.low = hips.high = angle;
      return trunk_.is_allowed(kAsDrawn, {hips}) &&
             std::all_of(links.begin(), links.end(),
                         [&](const TurnedLink& link) { return link.is_allowed(angle); });
    };
    std::optional<Proposal> out =
        with_turns(proposal, farthest(0.0, proposal.lower, kTurnHalvings, is_allowed),
                   farthest(0.0, proposal.upper, kTurnHalvings, is_allowed));
    if (!hips.about.empty()) hips_.emplace(proposal.name, hips);
    const bool less = !out || out->lower > proposal.lower || out->upper < proposal.upper;
    if (less) tell_ranges(axes);
    return out;
  }

  /// A joint's own range decides at how many angles things keep clear; and that of what carries it.
  void tell_ranges(const TurnedAxes& axes) {
    for (const PlacedLimb& limb : limbs_)
      for (std::size_t k = 0; k < limb.of->joints.size(); ++k) {
        if (axes.count(joint_name(limb, limb.of->joints[k])) == 0) continue;
        for (std::size_t at = k == 0 ? 0 : k - 1; at <= k; ++at) {
          const auto range = link_ends(limb, at).range;
          if (range[1] - range[0] > kHalfTurn) boundless_.insert(limb.of->joints[at].name);
        }
      }
  }

  /// Inwards to a thousandth of a radian; nothing where too little is left.
  static std::optional<Proposal> with_turns(const Proposal& proposal, double low, double high) {
    Proposal out = proposal;
    if (low > out.lower) out.lower = std::min(0.0, std::ceil(low * kPerAngle) / kPerAngle);
    if (high < out.upper) out.upper = std::max(0.0, std::floor(high * kPerAngle) / kPerAngle);
    if (out.upper - out.lower < std::min(kLeastTurn, proposal.upper - proposal.lower))
      return std::nullopt;
    return out;
  }

  /// What hips may turn at once: all in proportion, so that the trunk fits with each at either
  /// bound.
  void narrow_hips(std::vector<std::optional<Proposal>>& found) {
    const auto at_share = [&](double share) {
      std::vector<HipTurn> out;
      for (const std::optional<Proposal>& each : found) {
        const auto own = each ? hips_.find(each->name) : hips_.end();
        if (own == hips_.end()) continue;
        out.push_back({own->second.about, share * each->lower, share * each->upper});
      }
      return out;
    };
    const double share = farthest(0.0, 1.0, kTurnHalvings, [&](double of_bounds) {
      return trunk_.is_allowed(kAsDrawn, at_share(of_bounds));
    });
    for (std::optional<Proposal>& each : found)
      if (each && hips_.count(each->name))
        each = with_turns(*each, share * each->lower, share * each->upper);
    turned_hips_ = at_share(1.0);
  }

  std::optional<Proposal> narrow_trunk(const Proposal& proposal) {
    const bool is_length = proposal.binding.starts_with("stretch x");
    double& own = is_length ? length_ : width_;
    const auto is_allowed = [&](double scale) {
      const Eigen::Vector3d scales =
          is_length ? Eigen::Vector3d(scale, width_, 1.0) : Eigen::Vector3d(length_, scale, 1.0);
      return trunk_.is_allowed(scales, turned_hips_);
    };
    std::optional<Proposal> out = narrow(proposal, is_allowed);
    if (out) own = out->lower / out->value;
    return out;
  }

  void leave_out(const std::string& name) {
    out_.left_out.push_back(name + ": clearance and bed leave its parts no room to change");
    without_room_.push_back(name);
  }

  void tell(const Proposal& before, const Proposal& now) {
    if (now.lower > before.lower || now.upper < before.upper)
      narrowed_.push_back(
          fmt::format("{} {:.4g} to {:.4g} {}", now.name, now.lower, now.upper, now.unit));
  }

  std::optional<Proposal> narrow_link(const Proposal& proposal,
                                      const std::vector<std::string>& names) {
    std::vector<const PrintedLink*> links;
    for (const PlacedLimb& limb : limbs_)
      for (std::size_t k = 0; k < limb.of->joints.size(); ++k) {
        const std::string name = link_name(limb, limb.of->joints[k]);
        if (std::find(names.begin(), names.end(), name) == names.end()) continue;
        links.push_back(&link_of(limb, k));
        if (!links.back()->fits()) too_large_.push_back(name);
      }
    return narrow(proposal, [&](double scale) {
      return std::all_of(links.begin(), links.end(),
                         [&](const PrintedLink* link) { return link->is_allowed(scale); });
    });
  }

  /// A length, as far as its scale is allowed; nothing where there is no room.
  static std::optional<Proposal> narrow(const Proposal& proposal,
                                        const std::function<bool(double)>& is_allowed) {
    const double low = farthest(1.0, proposal.lower / proposal.value, kScaleHalvings, is_allowed),
                 high = farthest(1.0, proposal.upper / proposal.value, kScaleHalvings, is_allowed);
    // Inwards to a millionth of a metre, as far as there is room.
    Proposal out = proposal;
    if (low > proposal.lower / proposal.value)
      out.lower = std::min(out.value, std::ceil(low * out.value * kPerGrain) / kPerGrain);
    if (high < proposal.upper / proposal.value)
      out.upper = std::max(out.value, std::floor(high * out.value * kPerGrain) / kPerGrain);
    if (out.upper - out.lower < kLeastRange * out.value) return std::nullopt;
    return out;
  }

  const Assembly& assembly_;
  const std::vector<PlacedLimb> limbs_;
  const PrintedTrunk trunk_;
  std::map<std::string, HipTurn> hips_;  // by proposal
  std::vector<HipTurn> turned_hips_;     // within the bounds that are found
  std::map<std::string, PrintedLink> links_;
  double length_ = 1.0, width_ = 1.0;  // of the trunk, at which the other is looked at
  std::vector<std::string> narrowed_, without_room_, too_large_;
  std::set<std::string>
      boundless_;  // joints whose axes turn less than asked, of half a turn or more
  PrintBounds out_;
};

}  // namespace

PrintBounds print_bounds(const Assembly& assembly, const std::vector<Proposal>& proposals) {
  return BoundsOfPrint(assembly).run(proposals);
}

}  // namespace legwright
