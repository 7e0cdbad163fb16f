// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mjcf/text/file_state.hpp"
#include "mjcf/text/mujoco_pointers.hpp"

namespace legwright {

/// The models that were compiled last, by the text that they are of: that of a design is compiled
/// by everyone who writes, checks or plays it, some six times in a row.
class RecentModels {
 public:
  /// A copy of the model of a text, if the files that it names are as they were; else null.
  ModelPointer find(const std::string& xml, const std::filesystem::path& file);
  /// @param file of the text, beside which the files are that it names. Throws InputError where the
  /// text is no XML
  void keep(const std::string& xml, const std::filesystem::path& file, const mjModel& model);

 private:
  static constexpr std::size_t kKept = 4;
  using States = std::vector<std::pair<std::string, std::optional<FileState>>>;
  struct Kept {
    std::string xml;
    std::filesystem::path file;
    States files;
    ModelPointer model;
  };
  std::mutex mutex_;
  std::deque<Kept> kept_;  // the oldest first
};

}  // namespace legwright
