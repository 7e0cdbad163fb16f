// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/run/judged_sums.hpp"
#include "tools/run/record.hpp"

namespace legwright {

/// How far one factor may go, all others as planned.
struct RobustnessFactor {
  std::string name, label, unit;
  double nominal = 0.0;
  std::optional<double> low, high;  // last value that walks; none: walks at all that was tested
  std::optional<double> low_fails, high_fails;  // first value that does not
  double tested_low = 0.0, tested_high = 0.0;
  std::optional<std::string> low_cause, high_cause;
  int rollouts = 0;
};

/// A walk with all factors drawn together that failed.
struct FailedDraw {
  int sample = 0;
  std::string cause;
  double seconds = 0.0;  // until then
  ByName<double> values;
};

struct MonteCarlo {
  int samples = 0, survived = 0;
  double share = 0.0, share_low = 0.0, share_high = 1.0;  // with its 95 % interval
  ByName<std::pair<double, double>> spread;               // from which each factor was drawn
  std::map<std::string, int> causes;
  std::vector<FailedDraw> worst;  // that failed first
};

/// result/robustness.json; no wall time in it, so equal runs are equal bytes.
struct RobustnessRecord {
  static constexpr RecordKind kKind{"legwright/robustness", 1, "validate"};
  int cycles = 0;
  std::size_t seed = 0;
  std::optional<double> seconds;
  std::optional<std::string> undisturbed_cause;  // where it fails undisturbed: then all is empty
  std::vector<RobustnessFactor> factors;
  MonteCarlo monte_carlo;
  std::optional<JudgedSums> of = {};
};

void fields(Fields& f, RobustnessRecord& robustness);

}  // namespace legwright
