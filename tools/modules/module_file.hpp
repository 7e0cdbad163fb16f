// SPDX-License-Identifier: Apache-2.0
// A module as its file (TOML) says it, with where each figure is from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/assembly/module.hpp"
#include "tools/task/key_table.hpp"

namespace legwright {

/// A page or data sheet, and the keys whose figures it gives.
struct FigureSource {
  std::string title, address, note;
  std::vector<std::string> figures;
};

/// Figures without a source, and why they are as they are.
struct FigureAssumption {
  std::vector<std::string> figures;
  std::string why;
};

struct ModuleFile {
  std::filesystem::path file;
  Module module;
  std::vector<FigureSource> sources;
  std::vector<FigureAssumption> assumptions;
  std::vector<std::string> unknown;  // keys whose figures no source gives
  std::vector<std::string> doubts;   // what is hardly meant, with file, line and key

  /// How many sources give the figure of a key.
  std::size_t source_count(const std::string& figure) const;
};

/// Every key of a module file, in the order of the reference.
const std::vector<TaskKey>& module_keys();

/// Reads a module strictly: every key is listed in module_keys(), each figure has a source or an
/// assumption, and what a module of its kind may have is given or said to be unknown. Throws
/// InputError with all that is wrong: file, line, key, what was expected and how to mend it.
/// @param file for messages
ModuleFile parse_module(const std::string& text, const std::filesystem::path& file);

}  // namespace legwright
