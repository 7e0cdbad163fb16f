// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "mjcf/assembly/module.hpp"

namespace legwright {

/// Keys of a module file whose figures must be sourced or assumed where they are given.
const std::vector<std::string_view>& module_figures();

/// Whether a module of this kind gives that figure or says it to be unknown.
bool is_asked_for(ModuleKind kind, std::string_view figure);

}  // namespace legwright
