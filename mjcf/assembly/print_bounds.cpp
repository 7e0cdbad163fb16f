// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/print_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string_view>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/assembly/printed_link.hpp"
#include "mjcf/assembly/printed_trunk.hpp"
#include "mjcf/read/printed_robot.hpp"

namespace legwright {
namespace {

constexpr double kPerGrain = 1e6;                    // bounds are written to a millionth of a metre
constexpr double kLeastRange = 1e-3;                 // of a length, below which it is left out
constexpr int kScaleSteps = 8, kScaleHalvings = 13;  // to a bound: those of 0.25 to 1e-5

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
      if (proposal.binding == "stretch x: trunk")
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
