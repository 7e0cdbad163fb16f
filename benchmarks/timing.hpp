// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <time.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace legwright::bench {

/// CPU time of this thread [µs]: what other processes take does not count, though they do spoil the
/// caches.
inline double thread_microseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// One thing to be timed.
struct Contestant {
  std::string name;
  std::function<void()> run;
};

struct Times {
  std::string name;
  std::vector<double> microseconds;

  double min() const { return *std::min_element(microseconds.begin(), microseconds.end()); }
  double median() const {
    std::vector<double> sorted = microseconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

/// Runs all contestants in turn, so that a change of the machine's speed hits all of them alike:
/// only ratios of such times are solid. The first round is thrown away; then at least `rounds`, and
/// until `seconds` of CPU time are used.
inline std::vector<Times> interleave(const std::vector<Contestant>& contestants, int rounds = 15,
                                     double seconds = 1.0) {
  std::vector<Times> times;
  for (const Contestant& contestant : contestants) times.push_back({contestant.name, {}});
  const double start = thread_microseconds();
  for (int round = 0; round <= rounds || thread_microseconds() - start < 1e6 * seconds; ++round)
    for (std::size_t k = 0; k < contestants.size(); ++k) {
      const double before = thread_microseconds();
      contestants[k].run();
      const double taken = thread_microseconds() - before;
      if (round > 0) times[k].microseconds.push_back(taken);
    }
  return times;
}

/// {"name": {"min_us": …, "median_us": …, "runs": …}, …}
inline nlohmann::ordered_json to_json(const std::vector<Times>& times) {
  nlohmann::ordered_json result;
  for (const Times& t : times)
    result[t.name] = {
        {"min_us", t.min()}, {"median_us", t.median()}, {"runs", t.microseconds.size()}};
  return result;
}

/// Processor, compiler and build type: a time means nothing without them.
inline nlohmann::ordered_json machine() {
  std::string line, cpu = "unknown";
  for (std::ifstream info("/proc/cpuinfo"); std::getline(info, line);)
    if (line.rfind("model name", 0) == 0) {
      cpu = line.substr(std::min(line.size(), line.find(':') + 2));
      break;
    }
  return {{"cpu", cpu}, {"compiler", __VERSION__}, {"build_type", LEGWRIGHT_BUILD_TYPE}};
}

}  // namespace legwright::bench
