// SPDX-License-Identifier: Apache-2.0
#include "tools/run/robot_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "mjcf/text/safe_path.hpp"
#include "tools/files/io_error.hpp"

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

/// Whether a regular file has these bytes already.
bool holds(const fs::path& file, const std::string& bytes) {
  return fs::is_regular_file(fs::symlink_status(file)) && fs::file_size(file) == bytes.size() &&
         read_regular_file(file, bytes.size()) == bytes;
}

/// That a file goes into; nothing for one in the current folder, which is there.
void make_folder_of(const fs::path& file) {
  if (file.has_parent_path()) fs::create_directories(file.parent_path());
}

void write_asset(const AssetFile& asset, const fs::path& to, Durability durability) {
  if (fs::exists(fs::symlink_status(to)) && holds(to, read_regular_file(asset.source, asset.bytes)))
    return;
  make_folder_of(to);
  if (asset.may_link && linked(asset.source, to)) return;
  write_file(to, read_regular_file(asset.source, asset.bytes), durability);
}

/// What is included, and assets.
void write_others(const fs::path& folder, const RobotFiles& files, Durability durability) {
  for (const IncludedFile& included : files.includes()) {
    const fs::path to = folder / included.path;
    make_folder_of(to);
    write_file(to, included.text, durability);
  }
  for (const AssetFile& asset : files.assets()) write_asset(asset, folder / asset.path, durability);
}

fs::path folder_behind_links(const fs::path& file) {
  return fs::weakly_canonical(fs::absolute(file)).parent_path();
}

}  // namespace

void write_robot_files(const fs::path& folder, const RobotFiles& files, Durability durability) {
  const RobotFiles own = files.gathered();
  write_file(folder / "robot.xml", own.main_text(), durability);
  write_others(folder, own, durability);
}

void write_main_file(const fs::path& output, const RobotFiles& files) {
  const fs::path from = folder_behind_links(files.file()), to = folder_behind_links(output);
  if (from == to) return write_file(output, files.main_text());
  const RobotFiles own = files.gathered();
  const auto check = [&](const fs::path& path, const auto& bytes) {
    const bool taken = fs::exists(fs::symlink_status(to / path)) && !holds(to / path, bytes());
    if (*path.begin() == output.filename())
      throw IoError(fmt::format(
          "{}: the robot includes or shows a file of this name, which is written beside it; give "
          "the output another name",
          output.string()));
    if (taken)
      throw IoError(
          fmt::format("{}: another file is there, which the one of this name that the robot "
                      "includes or shows would replace; write {} into a new folder",
                      (output.parent_path() / path).string(), output.filename().string()));
    for (fs::path above = path.parent_path(); !above.empty(); above = above.parent_path())
      if (fs::is_symlink(fs::symlink_status(to / above)))
        throw IoError(
            fmt::format("{}: is a symbolic link, through which nothing is written; write "
                        "{} into a new folder",
                        (output.parent_path() / above).string(), output.filename().string()));
  };
  for (const IncludedFile& included : own.includes())
    check(included.path, [&] { return included.text; });
  for (const AssetFile& asset : own.assets())
    check(asset.path, [&] { return read_regular_file(asset.source, asset.bytes); });
  fs::create_directories(to);
  write_others(output.parent_path(), own, Durability::power);
  write_file(output, own.main_text());
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
