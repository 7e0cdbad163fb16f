// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/report/design_effect.hpp"

namespace legwright {

/// An outer objective J as the amount that grows with it: of "peak_torque", which sums eighth
/// powers, the peak in the plan as a share of the motor's limit; of others J itself.
std::optional<double> outer_amount(const OuterRecord& outer, std::optional<double> J);

/// What became of the quantity that the body was to lower, in MuJoCo: "The body was to lower peak
/// torque. Measured: peak torque of a servo 1.13 N·m before, 1.61 N·m after (+42 %): it did not
/// fall." Empty without an outer objective.
/// @param rows as of effect_rows()
std::string outer_words(const RunRecord& run, const std::vector<EffectRow>& rows);

}  // namespace legwright
