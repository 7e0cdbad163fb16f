// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/source_tree.hpp"
#include "tools/modules/module_library.hpp"

namespace legwright::test {

/// The modules that come with the program.
inline const ModuleLibrary& installed_modules() {
  static const ModuleLibrary library({kSource / "modules"});
  return library;
}

}  // namespace legwright::test
