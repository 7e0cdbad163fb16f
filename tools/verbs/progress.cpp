// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

constexpr std::size_t kLastFew = 5;  // iterations whose medians are taken
constexpr std::size_t kTrend = 3;    // guesses before one is told

double median_of_last(const std::vector<double>& values) {
  std::vector<double> last(values.end() - static_cast<long>(std::min(values.size(), kLastFew)),
                           values.end());
  const auto middle = last.begin() + static_cast<long>(last.size() / 2);
  std::nth_element(last.begin(), middle, last.end());
  return *middle;
}

}  // namespace

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

void print_progress(const std::string& stage, int done, int total) {
  fmt::print(stderr, "{}\n", to_line(Json{{"stage", stage}, {"done", done}, {"total", total}}));
}

int TimeLeft::iterations() const {
  const int done = static_cast<int>(history_.size()) - 1;
  return done + iterations_left(history_, tolerance_, most_ - done);
}

std::optional<double> TimeLeft::after(int index, double value, double seconds) {
  if (index == 0) *this = TimeLeft(tolerance_, most_);
  history_.push_back(value);
  if (index > 0) seconds_.push_back(seconds);  // iteration 0 solves from scratch
  if (history_.size() < 5) return std::nullopt;
  ends_.push_back(index + iterations_left(history_, tolerance_, most_ - index));
  if (ends_.size() < kTrend) return std::nullopt;
  return std::max(median_of_last(ends_) - index, 1.0) * median_of_last(seconds_);
}

Progress::Mode Progress::mode_for_stderr(bool quiet) {
  return quiet ? Mode::quiet : ::isatty(STDERR_FILENO) ? Mode::live : Mode::lines;
}

Progress::Progress(Mode mode, const CodesignOptions& options, std::vector<std::string> names,
                   std::vector<std::string> units, std::string cost)
    : mode_(mode),
      time_left_(options.value_tolerance, options.max_iterations),
      names_(std::move(names)),
      units_(std::move(units)),
      cost_(std::move(cost)) {}

void Progress::start(const std::string& what) {
  if (mode_ == Mode::live) fmt::print(stderr, "\r\x1b[K{}", what);
  if (mode_ == Mode::lines) fmt::print(stderr, "{}\n", what);
  std::fflush(stderr);
}

void Progress::iteration(const RunLabel& label, const DesignIteration& iteration,
                         const std::vector<PlanQuality>& qualities) {
  const auto left = time_left_.after(iteration.index, iteration.value, iteration.seconds);
  if (mode_ == Mode::quiet) return;
  if (mode_ == Mode::json) {
    const int total = names_.size() == 1 ? time_left_.iterations() : 0;
    return print_progress("searching", iteration.index, total);
  }
  std::string run;
  if (names_.size() > 1)
    run = label.tasks.size() == names_.size() ? fmt::format("from {}: ", label.start)
                                              : fmt::format("{} alone: ", names_[label.tasks[0]]);
  std::string speeds;
  for (std::size_t k = 0; k < label.tasks.size(); ++k)
    speeds += fmt::format(
        "  {}{:.4f} of {:.4g} {}", names_.size() > 1 ? names_[label.tasks[k]] + " " : "speed ",
        qualities[k].speed_reached, qualities[k].speed_wanted, units_[label.tasks[k]]);
  const std::string time =
      left && names_.size() == 1 ? fmt::format("  ~{:.0f} s left", std::ceil(*left)) : "";
  fmt::print(stderr, "{}{}iteration {:3}  {} {:<10.5g}{}{}{}",
             mode_ == Mode::live ? "\r\x1b[K" : "", run, iteration.index, cost_, iteration.value,
             speeds, time, mode_ == Mode::live ? "" : "\n");
  std::fflush(stderr);
}

void Progress::finish() {
  if (mode_ == Mode::live) fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace legwright
