// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/session/state.hpp"
#include "tools/studio/opening.hpp"

namespace legwright {

/// What was designed of a robot that was built of modules, for the next that is built of the same
/// assembly.
struct CarriedDesign {
  std::string text;                      // of its tasks; empty: those that it was opened with
  std::map<std::string, double> values;  // of parameters that are not as given
  std::vector<std::string> locked;       // by hand
  std::map<std::string, std::pair<double, double>> bounds;  // those narrowed by hand
};

/// @param opened_text of the tasks that it was opened with
CarriedDesign carried_of(const SessionState& state, const std::string& opened_text);

/// Gives a robot that is about to be opened these tasks, where they fit it, and the bounds and
/// values of parameters that it still has, within its own bounds.
/// @return what was taken over and what was not, as sentences; empty where there is nothing
std::string carry_over(const CarriedDesign& carried, Opening& opening);

}  // namespace legwright
