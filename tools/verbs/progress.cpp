// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace legwright {

int iterations_left(const std::vector<double>& history, double tolerance, int most) {
  const std::size_t n = history.size();
  if (most <= 0) return 0;
  if (n < 5) return most;
  // Decreases over three iterations, now and one iteration before: assume that they shrink at this
  // rate.
  const double scale = std::max(std::abs(history[n - 1]), 1e-300);
  const double now = (history[n - 4] - history[n - 1]) / scale;
  const double before = (history[n - 5] - history[n - 2]) / scale;
  if (!(now > tolerance)) return 1;
  const double rate = std::clamp(now / std::max(before, 1e-300), 0.1, 0.95);
  return std::clamp(static_cast<int>(std::ceil(std::log(tolerance / now) / std::log(rate))), 1,
                    most);
}

Progress::Mode Progress::mode_for_stderr(bool quiet) {
  return quiet ? Mode::quiet : ::isatty(STDERR_FILENO) ? Mode::live : Mode::lines;
}

Progress::Progress(Mode mode, const CodesignOptions& options, std::string unit)
    : mode_(mode),
      tolerance_(options.value_tolerance),
      most_(options.max_iterations),
      unit_(std::move(unit)) {}

void Progress::start(const std::string& what) {
  if (mode_ == Mode::live) fmt::print(stderr, "\r\x1b[K{}", what);
  if (mode_ == Mode::lines) fmt::print(stderr, "{}\n", what);
  std::fflush(stderr);
}

void Progress::iteration(const DesignIteration& iteration, const PlanQuality& quality) {
  history_.push_back(iteration.value);
  if (iteration.index > 0)  // iteration 0 solves from scratch and says nothing about the others
    seconds_per_iteration_ = seconds_per_iteration_ == 0.0
                                 ? iteration.seconds
                                 : 0.7 * seconds_per_iteration_ + 0.3 * iteration.seconds;
  if (mode_ == Mode::quiet) return;
  const double left =
      seconds_per_iteration_ * iterations_left(history_, tolerance_, most_ - iteration.index);
  const std::string time =
      iteration.index == 0 ? "" : fmt::format("  ~{:.0f} s left", std::ceil(left));
  fmt::print(stderr, "{}iteration {:3}  F {:<10.5g} speed {:.4f} of {:.4g} {}{}{}",
             mode_ == Mode::live ? "\r\x1b[K" : "", iteration.index, iteration.value,
             quality.speed_reached, quality.speed_wanted, unit_, time,
             mode_ == Mode::live ? "" : "\n");
  std::fflush(stderr);
}

void Progress::finish() {
  if (mode_ == Mode::live) fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace legwright
