// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/overlap_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "mjcf/assembly/assembly_names.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/numbers.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

/// Where a module stands in the assembly: a part, or a joint or the foot of a limb; else the trunk.
struct Stand {
  const AssemblyPart* part = nullptr;
  const PlacedLimb* limb = nullptr;
  const AssemblyJoint* joint = nullptr;  // none: the foot

  int line() const {
    if (part) return part->line;
    if (!limb) return 0;
    return joint ? joint->line : limb->of->line;
  }
  const char* key() const {
    if (part) return "part.module";
    if (!limb) return "trunk";
    return joint ? "limb.joint" : "limb";
  }
  /// What the file says once for all mirror images and copies.
  const void* table() const {
    if (part) return part;
    if (!limb) return nullptr;
    return joint ? static_cast<const void*>(joint) : limb->of;
  }
};

/// Pairs of the same two tables.
struct Alike {
  ModuleOverlap deepest;
  Stand first, second;
  std::size_t count = 0;
  bool is_deep = false;

  bool is_of_trunk() const { return !first.table() || !second.table(); }
};

std::string named(const std::string& name, const Stand& at) {
  return at.line() > 0 ? fmt::format("{} (line {})", name, at.line()) : name;
}

/// Whether a limb goes from its hip across the mirror plane, into its image.
bool crosses_the_middle(const AssemblyLimb& limb) {
  double y = limb.hip.y() + limb.foot_offset.y();
  for (const AssemblyJoint& joint : limb.joints) y += joint.offset.y();
  return limb.mirrored && limb.hip.y() * (y - limb.hip.y()) < 0.0;
}

std::string wrong_side_cure(const AssemblyLimb& limb) {
  return fmt::format(
      "hip is of one side and the way from there to the foot goes to the other: give hip y = {}",
      format_number(rounded(-limb.hip.y())));
}

std::string limb_cure(const Stand& a, const Stand& b) {
  const AssemblyLimb& limb = *a.limb->of;
  if (&limb != b.limb->of) return "move one of the limbs by its hip";
  if (a.limb->name == b.limb->name)
    return "lengthen offset or foot_offset between them, or turn a servo by roll";
  if (a.limb->mirrored == b.limb->mirrored) return "lengthen step";
  if (crosses_the_middle(limb)) return wrong_side_cure(limb);
  return "move hip farther from the x-z plane, in which they mirror each other";
}

std::string cure(const Stand& a, const Stand& b) {
  if (a.part && b.part) return "move one of them by its position";
  if (a.part || b.part) return "move the part by its position, or the limb by hip";
  if (!a.limb || !b.limb) {
    const Stand& other = a.limb ? a : b;
    return other.limb && crosses_the_middle(*other.limb->of)
               ? wrong_side_cure(*other.limb->of)
               : "move it out of the trunk by hip or offset";
  }
  return limb_cure(a, b);
}

std::map<std::string, Stand> stands_of(const Assembly& assembly,
                                       const std::vector<PlacedLimb>& limbs) {
  std::map<std::string, Stand> out;
  for (std::size_t k = 0; k < assembly.parts.size(); ++k)
    out[part_name(assembly.parts[k], k)] = {&assembly.parts[k], nullptr, nullptr};
  for (const PlacedLimb& limb : limbs) {
    for (const AssemblyJoint& joint : limb.of->joints)
      out[servo_name(limb, joint)] = {nullptr, &limb, &joint};
    out[foot_name(limb, 0)] = {nullptr, &limb, nullptr};
  }
  return out;
}

std::vector<Alike> alike_pairs(const std::map<std::string, Stand>& stands,
                               const std::vector<ModuleOverlap>& overlaps) {
  std::vector<Alike> out;
  const auto stand = [&](const std::string& name) {
    const auto found = stands.find(name);
    return found == stands.end() ? Stand{} : found->second;
  };
  for (ModuleOverlap each : overlaps) {
    const auto order = [&](const std::string& name) {  // as the file has them; the trunk stays
      const Stand at = stand(name);
      return at.table() == nullptr ? std::numeric_limits<int>::max() : at.line();
    };
    if (order(each.first) > order(each.second)) std::swap(each.first, each.second);
    const Stand first = stand(each.first), second = stand(each.second);
    auto at = std::find_if(out.begin(), out.end(), [&](const Alike& other) {
      return other.first.table() == first.table() && other.second.table() == second.table() &&
             cure(other.first, other.second) == cure(first, second);
    });
    if (at == out.end()) at = out.insert(out.end(), {each, first, second, 0, false});
    if (at->deepest.depth < each.depth) {
      at->deepest = each;
      at->first = first;
      at->second = second;
    }
    ++at->count;
    at->is_deep = at->is_deep || each.is_deep;
  }
  return out;
}

std::string told(const Alike& pair) {
  const std::string others =
      pair.count == 1 ? "" : fmt::format(", the deepest of {} such pairs", pair.count);
  return fmt::format("{} at home{}",
                     depth_words(pair.deepest, named(pair.deepest.second, pair.second)), others);
}

}  // namespace

std::vector<std::string> overlap_notes(const Assembly& assembly,
                                       const std::vector<ModuleOverlap>& overlaps) {
  const std::vector<PlacedLimb> limbs = placed_limbs(assembly);
  std::vector<std::string> out;
  for (const Alike& pair : alike_pairs(stands_of(assembly, limbs), overlaps))
    out.push_back(fmt::format("{} stands {}: nobody can put that together; {}",
                              named(pair.deepest.first, pair.first), told(pair),
                              cure(pair.first, pair.second)));
  return out;
}

void refuse_overlaps(const Assembly& assembly, const std::vector<ModuleOverlap>& overlaps,
                     const std::filesystem::path& file) {
  const std::vector<PlacedLimb> limbs = placed_limbs(assembly);
  std::vector<InputError> reasons;
  for (const Alike& pair : alike_pairs(stands_of(assembly, limbs), overlaps))
    if (pair.is_deep || (assembly.print && !pair.is_of_trunk()))
      reasons.emplace_back(file.string(), pair.first.line(), pair.first.key(),
                           fmt::format("{} would stand {}, {}; {}", pair.deepest.first, told(pair),
                                       pair.is_deep ? "the middle of one in the other"
                                                    : "and [print] asks for parts that hold both",
                                       cure(pair.first, pair.second)));
  if (!reasons.empty()) throw InputError(std::move(reasons));
}

}  // namespace legwright
