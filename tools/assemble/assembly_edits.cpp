// SPDX-License-Identifier: Apache-2.0
#include "tools/assemble/assembly_edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "tools/assemble/replaced_module.hpp"
#include "tools/modules/assembly_text.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Kind = AssemblyItem::Kind;

constexpr int kMostCopies = 16;
constexpr double kBehind = 0.45;    // of the trunk's length, to a copy of one in its middle
constexpr double kStepShare = 2.0;  // of a hip's way from the trunk's middle, to a copy behind it

void remove_joint(Assembly& assembly, std::size_t index, std::size_t k) {
  AssemblyLimb& limb = assembly.limbs[index];
  if (limb.joints.size() == 1) {
    assembly.limbs.erase(assembly.limbs.begin() + static_cast<std::ptrdiff_t>(index));
    return;
  }
  if (k + 1 == limb.joints.size()) {
    limb.foot_offset += limb.joints[k].offset;
  } else if (k == 0) {
    limb.hip += limb.joints[1].offset;
    limb.joints[1].offset.setZero();
  } else {
    limb.joints[k + 1].offset += limb.joints[k].offset;
  }
  limb.joints.erase(limb.joints.begin() + static_cast<std::ptrdiff_t>(k));
}

/// Reads a value of a kind. Throws InputError that names the key.
template <class T>
T value_as(const Json& value, const std::string& key, const char* expected) {
  try {
    return value.get<T>();
  } catch (const Json::exception&) {
    throw InputError(
        fmt::format("'{}' is to be {}; expected {}", key, value.dump(-1, ' ', true), expected));
  }
}

Vector3d vector_value(const Json& value, const std::string& key) {
  const auto numbers = value_as<std::array<double, 3>>(value, key, "three numbers");
  return {numbers[0], numbers[1], numbers[2]};
}

double number_value(const Json& value, const std::string& key) {
  return value_as<double>(value, key, "a number");
}

[[noreturn]] void refuse_key(const AssemblyItem& item, const std::string& key,
                             const char* expected) {
  throw InputError(
      fmt::format("'{}' is no key of {}; expected {}", key, to_string(item), expected));
}

void set_of_trunk(Assembly& assembly, const AssemblyItem& item, const std::string& key,
                  const Json& value) {
  if (key == "name") {
    assembly.name = value_as<std::string>(value, key, "a text");
    return;
  }
  if (key != "size" && key != "mass") refuse_key(item, key, "name, size or mass");
  Module trunk = assembly.trunk;
  if (!is_own_box(trunk))
    throw InputError(fmt::format("'{}' is of a box; the trunk is the module {}", key, trunk.name));
  if (key == "size")
    trunk.outline.front().size = vector_value(value, key);
  else
    trunk.mass = number_value(value, key);
  assembly.trunk_as_printed = assembly.trunk_as_printed && key == "size";
  replace_module(assembly, item, trunk);
}

/// Copies stand behind each other: the last as far behind the trunk's middle as the first is before
/// it.
void set_copies(AssemblyLimb& limb, const Json& value, double trunk_length) {
  if (!value.is_number_integer())
    throw InputError(
        fmt::format("'copies' is to be {}; expected a whole number", value.dump(-1, ' ', true)));
  const auto count = value.get<std::int64_t>();
  if (count < 1 || count > kMostCopies)
    throw InputError(fmt::format("'copies' is to be {}; expected 1 to {}", count, kMostCopies));
  const std::size_t had = limb.names.size();
  const std::string first = limb.names.front();
  limb.names.resize(std::min(had, static_cast<std::size_t>(count)));
  for (std::size_t k = limb.names.size(); k < static_cast<std::size_t>(count); ++k)
    limb.names.push_back(fmt::format("{}{}", first, k + 1));
  if (had == 1 && count > 1 && limb.step.norm() == 0.0)
    limb.step = -(std::abs(limb.hip.x()) > kInThePlane ? kStepShare * limb.hip.x()
                                                       : kBehind * trunk_length) /
                static_cast<double>(count - 1) * Vector3d::UnitX();
}

void set_names(AssemblyLimb& limb, const Json& value) {
  auto names = value_as<std::vector<std::string>>(value, "names", "names");
  if (names.size() != limb.names.size())
    throw InputError(fmt::format("'names' has {}; expected {}, one for each of the copies",
                                 names.size(), limb.names.size()));
  limb.names = std::move(names);
}

void set_of_limb(AssemblyLimb& limb, const AssemblyItem& item, const std::string& key,
                 const Json& value, double trunk_length) {
  if (key == "names")
    set_names(limb, value);
  else if (key == "hip")
    limb.hip = vector_value(value, key);
  else if (key == "step")
    limb.step = vector_value(value, key);
  else if (key == "copies")
    set_copies(limb, value, trunk_length);
  else if (key == "mirror")
    limb.mirrored = value_as<bool>(value, key, "true or false");
  else
    refuse_key(item, key, "names, hip, step, copies or mirror");
}

void set_of_joint(AssemblyJoint& joint, const AssemblyItem& item, const std::string& key,
                  const Json& value) {
  if (key == "axis") {
    joint.axis = vector_value(value, key);
  } else if (key == "offset") {
    joint.offset = vector_value(value, key);
  } else if (key == "roll") {
    joint.roll = number_value(value, key);
  } else if (key == "name") {
    const bool follows = joint.link == joint.name + "_link";
    joint.name = value_as<std::string>(value, key, "a text");
    if (follows) joint.link = joint.name + "_link";
  } else if (key == "link") {
    joint.link = value_as<std::string>(value, key, "a text");
  } else if (key == "range") {
    joint.range.reset();
    if (!value.is_null())
      joint.range = value_as<std::array<double, 2>>(value, key, "two angles, or null");
  } else {
    refuse_key(item, key, "axis, offset, roll, range, name or link");
  }
}

}  // namespace

void remove_item(Assembly& assembly, const AssemblyItem& item) {
  const auto at = static_cast<std::ptrdiff_t>(item.index);
  switch (item.kind) {
    case Kind::part:
      assembly.parts.erase(assembly.parts.begin() + at);
      return;
    case Kind::limb:
      assembly.limbs.erase(assembly.limbs.begin() + at);
      return;
    case Kind::joint:
      remove_joint(assembly, item.index, item.joint);
      return;
    case Kind::trunk:
    case Kind::foot:
      break;
  }
  throw InputError(fmt::format("{} cannot be taken away; put another module in its place",
                               words_of(item, assembly)));
}

void set_value(Assembly& assembly, const AssemblyItem& item, const std::string& key,
               const Json& value) {
  switch (item.kind) {
    case Kind::trunk:
      return set_of_trunk(assembly, item, key, value);
    case Kind::part:
      if (key != "position") refuse_key(item, key, "position");
      assembly.parts[item.index].position = vector_value(value, key);
      return;
    case Kind::limb:
      return set_of_limb(assembly.limbs[item.index], item, key, value,
                         2.0 * extent_of(assembly.trunk).half.x());
    case Kind::joint:
      return set_of_joint(assembly.limbs[item.index].joints[item.joint], item, key, value);
    case Kind::foot:
      break;
  }
  if (key != "offset") refuse_key(item, key, "offset");
  assembly.limbs[item.index].foot_offset = vector_value(value, key);
}

}  // namespace legwright
