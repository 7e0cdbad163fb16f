// SPDX-License-Identifier: Apache-2.0
#include "tools/assemble/assembly_item.hpp"

#include <fmt/format.h>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

using Kind = AssemblyItem::Kind;

}  // namespace

std::string to_string(const AssemblyItem& item) {
  switch (item.kind) {
    case Kind::trunk:
      return "trunk";
    case Kind::part:
      return fmt::format("part/{}", item.index);
    case Kind::limb:
      return fmt::format("limb/{}", item.index);
    case Kind::joint:
      return fmt::format("limb/{}/joint/{}", item.index, item.joint);
    case Kind::foot:
      break;
  }
  return fmt::format("limb/{}/foot", item.index);
}

AssemblyItem item_named(const std::string& text, const Assembly& assembly) {
  AssemblyItem item;
  const auto is_it = [&] { return to_string(item) == text; };
  if (is_it()) return item;
  for (item.index = 0; item.index < assembly.parts.size(); ++item.index) {
    item.kind = Kind::part;
    if (is_it()) return item;
  }
  for (item.index = 0; item.index < assembly.limbs.size(); ++item.index) {
    for (const Kind kind : {Kind::limb, Kind::foot}) {
      item.kind = kind;
      if (is_it()) return item;
    }
    item.kind = Kind::joint;
    const std::size_t count = assembly.limbs[item.index].joints.size();
    for (item.joint = 0; item.joint < count; ++item.joint)
      if (is_it()) return item;
    item.joint = 0;
  }
  throw InputError(
      fmt::format("'{}' is nothing of this assembly; expected trunk, part/N, limb/N, "
                  "limb/N/joint/K or limb/N/foot, counted from 0, of what there is",
                  text));
}

std::string words_of(const AssemblyItem& item, const Assembly& assembly) {
  if (item.kind == Kind::trunk) return "the trunk";
  if (item.kind == Kind::part) return assembly.parts.at(item.index).module.name;
  const AssemblyLimb& limb = assembly.limbs.at(item.index);
  const std::string name = fmt::format("{}", fmt::join(limb.names, ", "));
  if (item.kind == Kind::limb) return "limb " + name;
  if (item.kind == Kind::foot) return "the foot of " + name;
  return fmt::format("the servo of {} in {}", limb.joints.at(item.joint).name, name);
}

}  // namespace legwright
