// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/allowed_paths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "tools/files/io_error.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

bool below(const fs::path& path, const fs::path& folder) {
  const auto [end, other] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

bool below_any(const fs::path& path, const std::vector<fs::path>& folders) {
  return std::any_of(folders.begin(), folders.end(),
                     [&](const fs::path& folder) { return below(path, folder); });
}

std::string listed(const std::vector<fs::path>& folders) {
  std::vector<std::string> names;
  names.reserve(folders.size());
  for (const fs::path& folder : folders) names.push_back(folder.string());
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

AllowedPaths::AllowedPaths(const std::vector<fs::path>& writable,
                           const std::vector<fs::path>& readable) {
  for (const fs::path& folder : writable) {
    if (!fs::is_directory(folder))
      throw IoError(folder.string() + ": is no folder; name folders that are there");
    writable_.push_back(fs::canonical(folder));
  }
  readable_ = writable_;
  for (const fs::path& folder : readable) allow_reading(folder);
}

void AllowedPaths::allow_reading(const fs::path& folder) {
  if (fs::is_directory(folder)) readable_.push_back(fs::canonical(folder));
}

fs::path AllowedPaths::resolved(const std::string& path) const {
  if (path.empty() || path.find('\0') != std::string::npos)
    throw InputError("a path is needed, and none is given");
  fs::path full = path;
  if (full.is_relative() && !writable_.empty()) full = writable_.front() / full;
  return fs::weakly_canonical(full);
}

fs::path AllowedPaths::to_read(const std::string& path) const {
  fs::path full = resolved(path);
  if (!below_any(full, readable_))
    throw InputError(full.string() + ": is outside of the folders that the studio may read, " +
                     listed(readable_) + "; name its folder with --roots");
  return full;
}

FileReach AllowedPaths::reach() const {
  return FileReach::below(readable_, "outside of the folders that the studio may read, " +
                                         listed(readable_) + "; name its folder with --roots");
}

fs::path AllowedPaths::to_write(const std::string& path) const {
  fs::path full = resolved(path);
  if (!below_any(full, writable_))
    throw InputError(full.string() + ": is outside of the folders that the studio may write, " +
                     listed(writable_) + "; name its folder with --roots");
  return full;
}

}  // namespace legwright
