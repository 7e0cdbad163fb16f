// SPDX-License-Identifier: Apache-2.0
// What is changed of an assembly besides the modules that are put onto it.
#pragma once

#include <string>

#include "mjcf/assembly/robot_assembly.hpp"
#include "tools/assemble/assembly_item.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {

/// Takes an item away. What is behind a joint stays where it is; with its last joint a limb goes.
/// Throws InputError for the trunk, and for a foot, which can only be replaced.
void remove_item(Assembly& assembly, const AssemblyItem& item);

/// Gives a key of an item another value, in the units of the assembly file: `axis`, `offset`,
/// `roll`, `range`, `name`, `link` of a joint; `names`, `hip`, `step`, `copies`, `mirror` of a
/// limb; `offset` of a foot; `position` of a part; `size`, `mass` of a trunk that is a box, `name`
/// of the robot at the trunk. Throws InputError for a key that is none, and for a value of another
/// kind; what values may be parse_assembly() says.
void set_value(Assembly& assembly, const AssemblyItem& item, const std::string& key,
               const Json& value);

}  // namespace legwright
