// SPDX-License-Identifier: Apache-2.0
#include "mjcf/assembly/assembly_names.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

namespace legwright {
namespace {

/// Names of one sort, each with what has it.
class NamesOnce {
 public:
  explicit NamesOnce(std::vector<NameClash>& clashes) : clashes_(clashes) {}

  /// @param of the limb of the file; null for what belongs to none
  void add(const std::string& name, const std::string& words, const AssemblyLimb* of) {
    const auto [found, fresh] = holders_.emplace(name, Holder{words, of});
    const Holder& first = found->second;
    if (fresh || first.words == words) return;
    if (told_.emplace(first.of, of).second) clashes_.push_back({name, first.words, words});
  }

  /// Those of another sort, of which a name may be the same.
  void next_sort() { holders_.clear(); }

 private:
  struct Holder {
    std::string words;
    const AssemblyLimb* of;
  };
  std::vector<NameClash>& clashes_;
  std::map<std::string, Holder> holders_;
  std::set<std::pair<const AssemblyLimb*, const AssemblyLimb*>> told_;
};

}  // namespace

std::string joint_name(const PlacedLimb& limb, const AssemblyJoint& joint) {
  return limb.name + "_" + joint.name;
}

std::string servo_name(const PlacedLimb& limb, const AssemblyJoint& joint) {
  return joint_name(limb, joint) + "_servo";
}

std::string mount_name(const PlacedLimb& limb, const AssemblyJoint& joint) {
  return joint_name(limb, joint) + "_mount";
}

std::string lever_name(const PlacedLimb& limb, const AssemblyJoint& joint) {
  return joint_name(limb, joint) + "_lever";
}

std::string rod_name(const PlacedLimb& limb, const AssemblyJoint& joint) {
  return joint_name(limb, joint) + "_rod";
}

std::string mount_arm_name(const PlacedLimb& limb, const AssemblyJoint& joint) {
  return mount_name(limb, joint) + "_arm";
}

std::string lever_arm_name(const PlacedLimb& limb, const AssemblyJoint& joint) {
  return lever_name(limb, joint) + "_arm";
}

std::string link_name(const PlacedLimb& limb, const AssemblyJoint& joint) {
  return limb.name + "_" + joint.link;
}

std::string hull_name(const PlacedLimb& limb, const AssemblyJoint& joint, const std::string& role) {
  return link_name(limb, joint) + "_" + role;
}

std::string foot_name(const PlacedLimb& limb, std::size_t shape) {
  return shape == 0 ? limb.name : fmt::format("{}_{}", limb.name, shape + 1);
}

std::string part_name(const AssemblyPart& part, std::size_t k) {
  return fmt::format("part_{}_{}", k + 1, part.module.name);
}

std::vector<NameClash> name_clashes(const Assembly& assembly) {
  std::vector<NameClash> clashes;
  NamesOnce names(clashes);
  const std::vector<PlacedLimb> limbs = placed_limbs(assembly);
  const auto of_limb = [](const PlacedLimb& limb, const char* what, const std::string& name) {
    return fmt::format("{} \"{}\" of limb \"{}\"", what, name, limb.name);
  };
  for (const PlacedLimb& limb : limbs)
    for (const AssemblyJoint& joint : limb.of->joints)
      names.add(joint_name(limb, joint), of_limb(limb, "joint", joint.name), limb.of);
  names.next_sort();
  for (std::size_t k = 0; k < assembly.parts.size(); ++k)
    names.add(part_name(assembly.parts[k], k), fmt::format("part {}", k + 1), nullptr);
  for (const PlacedLimb& limb : limbs)
    for (const AssemblyJoint& joint : limb.of->joints) {
      names.add(servo_name(limb, joint), of_limb(limb, "the servo of joint", joint.name), limb.of);
      names.add(link_name(limb, joint), of_limb(limb, "link", joint.link), limb.of);
      if (joint.is_linear())
        for (const auto& [name, what] : {std::pair(mount_arm_name(limb, joint), "mount"),
                                         std::pair(lever_arm_name(limb, joint), "lever")})
          names.add(name, of_limb(limb, fmt::format("the {} of joint", what).c_str(), joint.name),
                    limb.of);
      for (const char* const role : {"arm", "boss"})
        if (assembly.link_shape == LinkShape::hull)
          names.add(hull_name(limb, joint, role),
                    of_limb(limb, fmt::format("the {} of link", role).c_str(), joint.link),
                    limb.of);
    }
  names.next_sort();
  for (const PlacedLimb& limb : limbs)
    for (std::size_t k = 0; k < limb.of->foot.outline.size(); ++k)
      names.add(foot_name(limb, k),
                k == 0 ? fmt::format("the foot of limb \"{}\"", limb.name)
                       : fmt::format("shape {} of the foot of limb \"{}\"", k + 1, limb.name),
                limb.of);
  return clashes;
}

}  // namespace legwright
