// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "mjcf/text/file_reach.hpp"

namespace legwright {

/// Options of all verbs that read robots. add_verb() adds them to those whose own derive from here.
struct ReadingOptions {
  bool confined = false;
  /// Of the files that a robot names.
  FileReach reach() const;
  /// Where reading is confined, looks at all robots and scenes of a run (check_reach()).
  void check_run(const std::filesystem::path& root) const;
};

}  // namespace legwright
