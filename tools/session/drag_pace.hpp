// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

namespace legwright {

/// When the motions of a body that somebody's hand moves are solved: once the hand rests for a
/// moment, and every so often while it does not; then the next step waits for the end, else a fast
/// hand would interrupt all of them. Few steps wait: solves take a small share of the time, as
/// those between all its steps take the processor from the picture.
class DragPace {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kRest{60}, kLongest{1000};
  static constexpr std::chrono::milliseconds kShort{100};  // solves for which a step may wait
  static constexpr int kRarely = 24;  // a solve's durations between two of them, at least

  /// The body moved on.
  void move(Clock::time_point now) {
    if (!since_) since_ = now;
    due_ = std::min(now + kRest, *since_ + longest());
  }
  /// Solving begins, or no hand moves the body any more.
  void end() {
    since_.reset();
    due_ = {};
  }
  /// A solve was done. @param took how long it did
  void solved(Clock::duration took) { took_ = took; }
  /// Whether a solve that begins now is to be done in spite of further steps.
  bool must_end(Clock::time_point now) const {
    return since_ && now >= *since_ + longest() && took_ < kShort;
  }
  /// From when on motions are to be solved; long ago where no hand moves the body.
  Clock::time_point due() const { return due_; }

 private:
  Clock::duration longest() const { return std::max<Clock::duration>(kLongest, kRarely * took_); }

  std::optional<Clock::time_point> since_;  // of the first step that is not solved
  Clock::time_point due_{};
  Clock::duration took_{};  // the last solve
};

}  // namespace legwright
