// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tools/report/run_data.hpp"

namespace legwright {

/// An amount of an outer objective's quantity as people read it: "1.13 N·m", "179 cm³".
std::string outer_amount_words(const OuterRecord& outer, std::optional<double> amount);

/// What became of the quantity that the body was to lower, in the plan and in MuJoCo: "The body was
/// to lower peak torque. In the plan: 1.48 N·m before, 1.11 N·m after (−25 %). Measured: at half
/// gains 1.23 N·m before, 1.02 N·m after (−17 %); at default gains … . It did not fall at double
/// gains." Empty without an outer objective.
std::string outer_words(const RunData& data);

}  // namespace legwright
