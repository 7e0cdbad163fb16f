// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <thread>

#include "tools/verbs/handled_signals.hpp"

namespace legwright {

/// While one lives, a signal that asks the program to end, and that was not ignored from the start,
/// does so at once, whatever its threads do, and takes away what is not finished
/// (remove_unfinished()). StopSignals and PassedSignals take its place while they live. One at a
/// time.
class CleanEnd {
 public:
  /// Without a thread to be had, signals end the program as they always do.
  CleanEnd();
  ~CleanEnd();
  CleanEnd(const CleanEnd&) = delete;
  CleanEnd& operator=(const CleanEnd&) = delete;

 private:
  std::thread watcher_;
  std::optional<HandledSignals> handled_;
};

}  // namespace legwright
