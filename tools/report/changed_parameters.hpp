// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/report/parameter_view.hpp"
#include "tools/report/run_data.hpp"

namespace legwright {

/// A design parameter that is not what it was, and what that brought.
struct ChangedParameter {
  ParameterView view;
  double lowered = 0.0;  // F + J with it put back, less that of the result; 0: not known;
                         // infinite: no motion
  std::optional<PlayedGait> played = {};  // of that body, where it was played
};

/// The design parameters of a run that changed, in the one order in which all parts of a report
/// tell them.
struct ChangedParameters {
  std::vector<ChangedParameter> list;
  /// Whether that order is by what each buys (run.json's `put_back`, equal ones by their share of
  /// the allowed range), or by that share alone.
  bool by_cost = false;
  std::size_t main_count = 0;  // so many of the first are worth a sentence

  std::size_t at_bound() const;
  /// "1 of the 4 changed parameters stands at a bound: there the bound decided how far it went, not
  /// the cost."; empty where none does.
  std::string bound_words() const;
};

ChangedParameters changed_parameters(const RunRecord& run);

}  // namespace legwright
