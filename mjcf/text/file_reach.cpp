// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/file_reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace legwright {
namespace {

namespace fs = std::filesystem;

bool lies_below(const fs::path& file, const std::vector<fs::path>& folders) {
  return std::any_of(folders.begin(), folders.end(), [&](const fs::path& folder) {
    const auto [end, unused] =
        std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    return end == folder.end();
  });
}

}  // namespace

FileReach FileReach::own_folder(std::string rule) {
  FileReach out;
  out.own_folder_ = true;
  out.rule_ = std::move(rule);
  return out;
}

FileReach FileReach::below(std::vector<fs::path> folders, std::string rule) {
  FileReach out;
  out.folders_ = std::move(folders);
  out.rule_ = std::move(rule);
  return out;
}

std::vector<fs::path> FileReach::folders_of(const fs::path& home) const {
  return own_folder_ ? std::vector<fs::path>{home} : folders_;
}

std::string FileReach::fault_of_place(const fs::path& file, const fs::path& home) const {
  if (!limited() || lies_below(file, folders_of(home))) return "";
  return fmt::format("lies at {}, {}", file.string(), rule_);
}

std::string FileReach::fault_of_target(const fs::path& file, const fs::path& home) const {
  if (!limited()) return "";
  std::error_code error;
  const fs::path target = fs::canonical(file, error);
  const fs::path behind = error ? fs::path() : fs::canonical(home, error);
  if (!error && lies_below(target, folders_of(behind))) return "";
  return fmt::format("is reached by a symbolic link and lies at {}, {}", target.string(), rule_);
}

}  // namespace legwright
