// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/doubtful_assembly.hpp"

#include <fmt/format.h>

#include <set>

#include "optimizer/motion/task.hpp"
#include "tools/modules/assembly_text.hpp"
#include "tools/modules/doubts.hpp"
#include "tools/task/toml_text.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kLongest = 2.5;    // of a vector, of the trunk's diagonal; examples: 0.6
constexpr double kShortest = 5e-3;  // [m], of one that could be meant
constexpr double kLeastMaterial = 50.0, kMostMaterial = 12e3;  // [kg/m3]: foam, lead
constexpr double kOfGrams = 1e3;                               // kg/m3 in a g/cm3

class AssemblyDoubts {
 public:
  AssemblyDoubts(const Assembly& assembly, const toml::table& toml,
                 const std::filesystem::path& file, const ModuleLibrary& library)
      : assembly_(assembly),
        library_(library),
        size_(2.0 * extent_of(assembly.trunk).half.norm()),
        doubts_(toml, file) {}

  std::vector<std::string> run() {
    check_trunk();
    check_material();
    for (std::size_t k = 0; k < assembly_.parts.size(); ++k)
      check_length(fmt::format("part[{}].position", k), assembly_.parts[k].position);
    for (std::size_t k = 0; k < assembly_.limbs.size(); ++k)
      check_limb(fmt::format("limb[{}].", k), assembly_.limbs[k]);
    std::vector<std::string> all = doubts_.all();
    const std::vector<std::string> of_modules = doubts_of_modules();
    all.insert(all.begin(), of_modules.begin(), of_modules.end());
    return all;
  }

 private:
  void check_trunk() {
    if (!is_own_box(assembly_.trunk)) return;
    doubts_.check_density(assembly_.trunk.mass, assembly_.trunk.outline.front().volume(),
                          kLeastTrunkDensity, "trunk.mass", "trunk.size");
  }

  void check_material() {
    const double density = assembly_.link_density;
    if (density >= kLeastMaterial && density <= kMostMaterial) return;
    const double meant = kOfGrams * density;
    doubts_.add("link.density",
                density > kMostMaterial
                    ? fmt::format("is {:.4g} kg/m3, more than lead has; check it", density)
                : meant < kLeastMaterial || meant > kMostMaterial
                    ? fmt::format("is {:.4g} kg/m3, less than foam has; check it", density)
                    : fmt::format("is {0:.4g} kg/m3, less than foam has; {0:.4g} g/cm3 are {1:.4g} "
                                  "kg/m3",
                                  density, meant));
  }

  void check_length(const std::string& place, const Vector3d& given) {
    if (given.norm() <= kLongest * size_) return;
    const std::string other = shorter_vectors(given, [&](const Vector3d& each) {
      return each.norm() >= kShortest && each.norm() <= size_;
    });
    doubts_.add(place, fmt::format("is {} m, {:.2g} times as long as the trunk from corner to "
                                   "corner, {:.3g} m; {}",
                                   vector_text(given), given.norm() / size_, size_,
                                   other.empty() ? "check both" : other));
  }

  void check_limb(const std::string& place, const AssemblyLimb& limb) {
    check_length(place + "hip", limb.hip);
    check_length(place + "step", limb.step);
    for (std::size_t k = 0; k < limb.joints.size(); ++k) {
      const std::string at = fmt::format("{}joint[{}].", place, k);
      const AssemblyJoint& joint = limb.joints[k];
      check_length(at + "offset", joint.offset);
      if (joint.lever) check_length(at + "lever", *joint.lever);
      if (joint.mount) check_length(at + "mount", *joint.mount);
      doubts_.check_angles(at + "range");
    }
    check_length(place + "foot_offset", limb.foot_offset);
    check_friction(place + "foot", limb.foot);
  }

  void check_friction(const std::string& place, const Module& foot) {
    const Task task;
    if (!foot.friction || *foot.friction >= task.floor_friction || !feet_.insert(foot.name).second)
      return;
    doubts_.add(place, fmt::format("is {}, whose friction of {:.3g} is below that of the floor of "
                                   "tasks, {:.3g}, which holds whatever the foot has: give tasks "
                                   "[limits] floor_friction = {:.3g}, and friction = {:.3g} for "
                                   "the plan",
                                   foot.name, *foot.friction, task.floor_friction, *foot.friction,
                                   *foot.friction * task.friction / task.floor_friction));
  }

  /// Of each module once.
  std::vector<std::string> doubts_of_modules() {
    std::vector<std::string> out;
    std::set<std::string> seen;
    const auto add = [&](const Module& module) {
      const ModuleFile* file = library_.find_or_null(module.name);
      if (!file || !seen.insert(module.name).second) return;
      out.insert(out.end(), file->doubts.begin(), file->doubts.end());
    };
    if (!is_own_box(assembly_.trunk)) add(assembly_.trunk);
    for (const AssemblyPart& part : assembly_.parts) add(part.module);
    for (const AssemblyLimb& limb : assembly_.limbs) {
      for (const AssemblyJoint& joint : limb.joints) add(joint.servo);
      add(limb.foot);
    }
    return out;
  }

  const Assembly& assembly_;
  const ModuleLibrary& library_;
  const double size_;  // of the trunk, from corner to corner [m]
  std::set<std::string> feet_;
  Doubts doubts_;
};

}  // namespace

std::vector<std::string> doubts_on_assembly(const Assembly& assembly, const std::string& text,
                                            const std::filesystem::path& file,
                                            const ModuleLibrary& library) {
  const toml::table toml = parse_toml(text, file);
  return AssemblyDoubts(assembly, toml, file, library).run();
}

}  // namespace legwright
