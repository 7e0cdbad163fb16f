// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "optimizer/base/stopwatch.hpp"
#include "tools/run/record.hpp"

namespace legwright {

/// Where the time of the whole command goes, as the user waits for it [s].
class CommandTimes {
 public:
  /// Counts all since the last call, or since the start, as this part.
  void end_of(const char* part) {
    const double now = watch_.seconds();
    parts_.emplace_back(part, now - last_);
    last_ = now;
  }
  /// Adds the parts, and "command", all of it.
  void add_to(ByName<double>& seconds) const {
    seconds.of("command") = watch_.seconds();
    for (const auto& [part, duration] : parts_) seconds.of(part) = duration;
  }

 private:
  Stopwatch watch_;
  double last_ = 0.0;
  std::vector<std::pair<const char*, double>> parts_;
};

}  // namespace legwright
