// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "optimizer/solve/effect.hpp"
#include "tools/report/run_data.hpp"

namespace legwright {

/// A figure of the initial body, with the gait that is best for it, beside that of the co-designed
/// one.
struct EffectRow {
  std::string what, before, after;  // as people read them; "–" where there is none
  Effect effect = {};
  bool amount = false;  // of which there is more or less, not how well something is done
};

/// What can be compared of a run: what MuJoCo measured, masses, costs. Rows without a number on
/// either side are left out. Of speeds and tilts the worst of the gains, of torque and power what
/// was measured at default gains.
std::vector<EffectRow> effect_rows(const RunData& data);

/// In plain sentences: what of the body's change lowered the cost most, how much of it stands at a
/// bound, and whether masses went along. Empty where nothing changed.
std::string body_words(const RunData& data);
/// What that bought, and what got worse most of all. Empty where nothing changed.
std::string effect_words(const RunData& data);

}  // namespace legwright
