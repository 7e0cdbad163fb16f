// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace legwright {

/// A small bar that shows where values lie within their bounds: a hollow mark for before, a full
/// one for after.
std::string bounds_bar(double lower, double upper, double before, double after);

/// What was tried of a factor, and where the robot walked.
struct TriedRange {
  double tested_low = 0.0, tested_high = 0.0;
  std::optional<double> low{},
      high{};  // the last values that walk; without one it walks to the end
  std::optional<double> nominal{};
};

/// The factor's range as a bar: walked, failed, the nominal value as a mark. Wide ranges of
/// positive values have a log axis. Empty for a range that is none.
std::string range_bar(const TriedRange& range);

/// A share with its interval as a bar from 0 to 1; empty without a share.
std::string share_bar(std::optional<double> share, std::optional<double> low,
                      std::optional<double> high);

}  // namespace legwright
