// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/export_files.hpp"

#include <set>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/safe_path.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {

namespace fs = std::filesystem;

std::string free_name(std::string name, const RobotFiles& files) {
  std::set<std::string> taken;  // at the top of the folder, files and folders
  for (const IncludedFile& part : files.includes()) taken.insert(part.path.begin()->string());
  for (const AssetFile& asset : files.assets()) taken.insert(asset.path.begin()->string());
  while (taken.count(name + ".xml") > 0) name += "_robot";
  return name;
}

std::vector<std::string> write_robot(const RobotFiles& from, const fs::path& folder,
                                     const std::string& name) {
  const RobotFiles files = from.gathered();
  std::vector<std::string> others;
  const auto place = [&](const fs::path& path) {
    if (fs::exists(folder / path) || path == "scene.xml" || path == "README.md")
      throw InputError(files.file().string(), 0, path.generic_string(),
                       "this name is needed in the exported folder; rename the file");
    fs::create_directories((folder / path).parent_path());
    others.push_back(path.generic_string());
    return folder / path;
  };
  write_file(folder / name, files.main_text());
  for (const IncludedFile& part : files.includes()) write_file(place(part.path), part.text);
  for (const AssetFile& asset : files.assets()) {
    // Not linked: who edits the export must not change the run.
    write_file(place(asset.path), read_regular_file(asset.source, asset.bytes));
  }
  return others;
}

}  // namespace legwright
