// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/modules/module_file.hpp"

namespace legwright {

/// The modules that are installed with the program, and those of the user's own folders.
class ModuleLibrary {
 public:
  /// Reads every `*.toml` of each folder, in the order of their names. A module of a later folder
  /// takes the place of one of the same name. Assemblies, tasks and studies, which have no `kind`,
  /// are passed over. Throws InputError for another file that is no module or two of one name in
  /// one folder, IoError for a folder that is not there or holds none.
  explicit ModuleLibrary(const std::vector<std::filesystem::path>& folders);

  /// Sorted by kind, then by name.
  const std::vector<ModuleFile>& modules() const { return modules_; }
  /// Throws InputError that offers the nearest name. Letters count as large and small ones.
  const ModuleFile& find(const std::string& name) const;
  /// Null where there is none of that name.
  const ModuleFile* find_or_null(const std::string& name) const;
  std::vector<std::string> names() const;

 private:
  void read_folder(const std::filesystem::path& folder);
  std::vector<ModuleFile> modules_;
};

/// The folder of the modules that came with the program, beside it. Throws IoError where it is not
/// there.
std::filesystem::path installed_modules();

/// The installed library with a user's folders behind it.
ModuleLibrary library_with(const std::vector<std::string>& own_folders);

}  // namespace legwright
