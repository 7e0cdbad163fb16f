// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace legwright {

/// What is done now, and how many of its parts are done of how many. Called from several threads,
/// one at a time.
using ProgressListener = std::function<void(const std::string&, int, int)>;

/// Tells a listener of one stage: at once that it begins, then of each part that is done.
class StageProgress {
 public:
  StageProgress(ProgressListener listener, std::string stage, int total)
      : listener_(std::move(listener)), stage_(std::move(stage)), total_(total) {
    if (listener_) listener_(stage_, 0, total_);
  }
  void one_more() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (listener_) listener_(stage_, done_, total_);
  }

 private:
  ProgressListener listener_;
  std::string stage_;
  std::mutex mutex_;
  int done_ = 0, total_;
};

}  // namespace legwright
