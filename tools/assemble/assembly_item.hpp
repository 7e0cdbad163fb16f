// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "mjcf/assembly/robot_assembly.hpp"

namespace legwright {

/// Something of an assembly that can be pointed at. Of mirror images and copies it is one thing, as
/// in the file.
struct AssemblyItem {
  enum class Kind { trunk, part, limb, joint, foot };
  Kind kind = Kind::trunk;
  std::size_t index = 0;  // of the part or limb, from 0
  std::size_t joint = 0;  // of the limb

  bool operator==(const AssemblyItem&) const = default;
};

/// `trunk`, `part/0`, `limb/1`, `limb/1/joint/0`, `limb/1/foot`.
std::string to_string(const AssemblyItem& item);

/// The item of such a text. Throws InputError where the assembly has none of it.
AssemblyItem item_named(const std::string& text, const Assembly& assembly);

/// What an item is, in words: `the servo of knee in F`.
std::string words_of(const AssemblyItem& item, const Assembly& assembly);

}  // namespace legwright
