// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/report/run_data.hpp"

namespace legwright {

/// A figure of the initial body, with the gait that is best for it, beside that of the co-designed one.
struct BoughtRow {
  std::string what, before, after;  // as people read them; "–" where there is none
  /// (after − before)/before, where both are numbers and before is not 0
  std::optional<double> change = std::nullopt;
  double worse = 0.0;  // by how much it got worse, as a share; 0 where it did not or nobody can say
};

/// What can be compared of a run: what MuJoCo measured, masses, costs. Rows without a number on either side are left
/// out. Of speeds and tilts the worst of the gains, of torque and power what was measured at default gains.
std::vector<BoughtRow> bought_rows(const RunData& data);

/// In plain sentences: what of the body's change lowered the cost most, how much of it stands at a bound, and whether
/// masses went along. Empty where nothing changed.
std::string body_words(const RunData& data);
/// What that bought, and what got worse most of all. Empty where nothing changed.
std::string bought_words(const RunData& data);

/// "−31 %", "+4.2 %", "as before"
std::string change_words(double change);

}  // namespace legwright
