// SPDX-License-Identifier: Apache-2.0
#include "tools/run/robot_folder.hpp"

#include <algorithm>
#include <system_error>

#include "mjcf/text/safe_path.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

bool linked(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_hard_link(from, to, error);
  if (error == std::errc::file_exists)
    throw std::system_error(error, "cannot write " + to.string());
  return !error;
}

void write_asset(const AssetFile& asset, const fs::path& to, Durability durability) {
  fs::create_directories(to.parent_path());
  if (asset.may_link && linked(asset.source, to)) return;
  write_file(to, read_regular_file(asset.source, asset.bytes), durability);
}

}  // namespace

void write_robot_files(const fs::path& folder, const RobotFiles& files, Durability durability) {
  write_file(folder / "robot.xml", files.main_text(), durability);
  for (const IncludedFile& included : files.includes()) {
    const fs::path to = folder / included.path;
    fs::create_directories(to.parent_path());
    write_file(to, included.text, durability);
  }
  for (const AssetFile& asset : files.assets()) write_asset(asset, folder / asset.path, durability);
}

void copy_design(const fs::path& from, const fs::path& to, const RobotFiles& files) {
  if (!fs::create_directory(to))
    throw std::system_error(std::make_error_code(std::errc::file_exists),
                            "cannot write " + to.string());
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(from)) {
    const fs::path path = entry.path().lexically_relative(from);
    if (entry.is_directory()) {
      fs::create_directory(to / path);
      continue;
    }
    const bool is_asset = std::any_of(files.assets().begin(), files.assets().end(),
                                      [&](const AssetFile& asset) { return asset.path == path; });
    if (!is_asset || !linked(entry.path(), to / path)) fs::copy_file(entry.path(), to / path);
  }
}

}  // namespace legwright
