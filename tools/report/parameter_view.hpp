// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/run/run_record.hpp"

namespace legwright {

/// A design parameter as run.json has it, in the units people think in.
struct ParameterView {
  std::string name, sentence;
  bool angle = false;
  double initial = 0.0, final = 0.0, lower = 0.0, upper = 0.0;  // SI
  /// mm or degrees
  double shown(double value) const;
  std::string with_unit(double value) const;
  std::string in_radian(double value) const;
  std::string change() const;
  double share_of_range() const;
  /// "lower bound", "upper bound" or nothing.
  std::string at_bound() const;
  /// The same for another value.
  std::string bound_of(double value) const;
};
std::vector<ParameterView> parameters_of(const RunRecord& run);

}  // namespace legwright
