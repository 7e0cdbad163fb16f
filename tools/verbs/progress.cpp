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

Progress::Progress(Mode mode, const CodesignOptions& options, std::vector<std::string> names,
                   std::vector<std::string> units)
    : mode_(mode),
      tolerance_(options.value_tolerance),
      most_(options.max_iterations),
      names_(std::move(names)),
      units_(std::move(units)) {}

void Progress::start(const std::string& what) {
  if (mode_ == Mode::live) fmt::print(stderr, "\r\x1b[K{}", what);
  if (mode_ == Mode::lines) fmt::print(stderr, "{}\n", what);
  std::fflush(stderr);
}

void Progress::iteration(const RunLabel& label, const DesignIteration& iteration,
                         const std::vector<PlanQuality>& qualities) {
  if (iteration.index == 0) history_.clear();  // another start
  history_.push_back(iteration.value);
  if (iteration.index > 0)  // iteration 0 solves from scratch and says nothing about the others
    seconds_per_iteration_ = seconds_per_iteration_ == 0.0
                                 ? iteration.seconds
                                 : 0.7 * seconds_per_iteration_ + 0.3 * iteration.seconds;
  if (mode_ == Mode::quiet) return;
  std::string run;
  if (names_.size() > 1)
    run = label.tasks.size() == names_.size() ? fmt::format("from {}: ", label.start)
                                              : fmt::format("{} alone: ", names_[label.tasks[0]]);
  std::string speeds;
  for (std::size_t k = 0; k < label.tasks.size(); ++k)
    speeds += fmt::format(
        "  {}{:.4f} of {:.4g} {}", names_.size() > 1 ? names_[label.tasks[k]] + " " : "speed ",
        qualities[k].speed_reached, qualities[k].speed_wanted, units_[label.tasks[k]]);
  const double left =
      seconds_per_iteration_ * iterations_left(history_, tolerance_, most_ - iteration.index);
  const std::string time = iteration.index == 0 || names_.size() > 1
                               ? ""
                               : fmt::format("  ~{:.0f} s left", std::ceil(left));
  fmt::print(stderr, "{}{}iteration {:3}  F {:<10.5g}{}{}{}", mode_ == Mode::live ? "\r\x1b[K" : "",
             run, iteration.index, iteration.value, speeds, time, mode_ == Mode::live ? "" : "\n");
  std::fflush(stderr);
}

void Progress::finish() {
  if (mode_ == Mode::live) fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace legwright
