// SPDX-License-Identifier: Apache-2.0
// What an assembled robot's file says of its modules, for whoever prints what is between them.
#pragma once

#include <string>
#include <string_view>

#include "mjcf/assembly/module.hpp"

namespace legwright {

/// The <text name="legwright_module/OF" data="NAME KIND MASS kg | body OF | joint JOINT | price P |
/// cable PLACE PLACE | body PLACE: x y z nx ny nz | horn PLACE: x y z nx ny nz"/> of a module;
/// joint, price and the attachments at which cables leave where it has them. Where its attachments
/// are from the origin of that body or geom [m], and their normals, in the axes of the body; of
/// those on the horn with the joint at zero. Where the screws are known their size follows the
/// place's name, and their holes its normal. So a file tells what was built, whatever becomes of
/// the library.
/// @param sort `body` or `geom`. @param joint that a servo turns; empty: none
std::string module_declaration(const Module& module, const ModulePlace& place,
                               std::string_view sort, const std::string& of,
                               const std::string& joint = "");

}  // namespace legwright
