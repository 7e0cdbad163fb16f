// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace legwright {

/// Where the files that a robot names may lie: anywhere, as for MuJoCo, or below some folders. What
/// counts is where a file lies, behind all symbolic links, not how it is named.
class FileReach {
 public:
  /// Anywhere.
  FileReach() = default;
  /// Below the folder of the robot's main file. @param rule who says so and how to mend it
  static FileReach own_folder(std::string rule);
  /// Below these folders, given without links. @param rule who says so and how to mend it
  static FileReach below(std::vector<std::filesystem::path> folders, std::string rule);

  /// What is wrong with the place of a file; empty where it may be read. No disk is asked.
  /// @param file absolute, without `..` @param home of the robot's main file, the same
  std::string fault_of_place(const std::filesystem::path& file,
                             const std::filesystem::path& home) const;
  /// The same of a file that is there, behind its links.
  std::string fault_of_target(const std::filesystem::path& file,
                              const std::filesystem::path& home) const;

 private:
  bool limited() const { return own_folder_ || !folders_.empty(); }
  std::vector<std::filesystem::path> folders_of(const std::filesystem::path& home) const;

  bool own_folder_ = false;
  std::vector<std::filesystem::path> folders_;
  std::string rule_;
};

}  // namespace legwright
