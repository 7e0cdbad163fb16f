// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tests/support/source_tree.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/modules/assembly_file.hpp"

namespace legwright::test {

inline const ModuleLibrary& installed_library() {
  static const ModuleLibrary library({kSource / "modules"});
  return library;
}

/// An assembly of the examples.
inline Assembly assembly_of(const std::string& name) {
  const auto file = kExamples / "assemblies" / (name + ".toml");
  return parse_assembly(read_file(file), file, installed_library());
}

inline const Module& module_of(const std::string& name) {
  return installed_library().find(name).module;
}

}  // namespace legwright::test
