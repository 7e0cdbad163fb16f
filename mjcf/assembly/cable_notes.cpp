// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/cable_notes.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <set>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/assembly/limb_hulls.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

/// By how much the joint's servo may be turned for another side to face the horn above [rad].
constexpr double kQuarter = 1.5708;

/// A roll of the servo at the far end of a link with which its cables leave elsewhere; empty where
/// a quarter of a turn and a half do not do.
std::string roll_that_frees(const Assembly& assembly, const PlacedLimb& limb, std::size_t joint) {
  AssemblyLimb turned = *limb.of;
  PlacedLimb placed = limb;
  placed.of = &turned;
  for (const double turn : {kQuarter, -kQuarter, 2.0 * kQuarter}) {
    turned.joints[joint + 1].roll = limb.of->joints[joint + 1].roll + turn;
    const LinkHulls hulls = hulls_of_link(assembly, placed, joint);
    if (!hulls.hulls.empty() && hulls.cable_at.empty())
      return format_number(rounded(turned.joints[joint + 1].roll));
  }
  return "";
}

std::string note_on(const Assembly& assembly, const PlacedLimb& limb, std::size_t joint,
                    const std::string& attachment) {
  const AssemblyLimb& of = *limb.of;
  const bool is_last = joint + 1 == of.joints.size();
  const Module& module = is_last ? of.foot : of.joints[joint + 1].servo;
  const int line = is_last ? of.line : of.joints[joint + 1].line;
  const std::string roll = is_last ? "" : roll_that_frees(assembly, limb, joint),
                    whose = is_last ? "the foot" : of.joints[joint + 1].name;
  return fmt::format(
      "the connector of {} lies on \"{}\" of {} ({}{}), where a cable leaves and no other "
      "attachment faces the horn: `legwright parts` cuts the cable's slot through it, and little "
      "or nothing holds the module; {}let the module's `cable` name another side, or give it an "
      "[[attachment]] beside the cable",
      link_name(limb, of.joints[joint]), attachment, module.name, whose,
      line > 0 ? fmt::format(", line {}", line) : "",
      roll.empty() ? "" : fmt::format("give {} roll = {}, ", whose, roll));
}

}  // namespace

std::vector<std::string> notes_on_cables(const Assembly& assembly) {
  std::vector<std::string> out;
  std::set<const AssemblyLimb*> told;
  for (const PlacedLimb& limb : placed_limbs(assembly)) {
    if (!told.insert(limb.of).second) continue;
    const std::vector<LinkHulls> hulls = limb_hulls(assembly, limb);
    for (std::size_t k = 0; k < hulls.size(); ++k)
      if (!hulls[k].cable_at.empty()) out.push_back(note_on(assembly, limb, k, hulls[k].cable_at));
  }
  return out;
}

}  // namespace legwright
