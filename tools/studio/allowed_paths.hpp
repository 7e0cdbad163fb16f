// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/text/file_reach.hpp"

namespace legwright {

/// The folders that a page may read and write below.
class AllowedPaths {
 public:
  /// @param writable folders that are there @param readable more of them, to read from
  AllowedPaths(const std::vector<std::filesystem::path>& writable,
               const std::vector<std::filesystem::path>& readable);

  /// The path without links and dots, which starts in the first folder where it is relative. Throws
  /// InputError where it is not below one that may be read.
  std::filesystem::path to_read(const std::string& path) const;
  /// The same of one that may be written, and need not be there.
  std::filesystem::path to_write(const std::string& path) const;
  const std::vector<std::filesystem::path>& writable() const { return writable_; }
  /// What a robot that is read may name.
  FileReach reach() const;
  void allow_reading(const std::filesystem::path& folder);

 private:
  std::filesystem::path resolved(const std::string& path) const;

  std::vector<std::filesystem::path> writable_, readable_;
};

}  // namespace legwright
