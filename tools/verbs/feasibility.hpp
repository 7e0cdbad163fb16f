// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/run/design_folder.hpp"

namespace legwright {

/// Why a plan does not do its task: empty if it does. Coarse on purpose: physics gives the verdict
/// (`validate`), this only catches plans that miss the speed or whose constraints are plainly
/// broken.
/// @param usable false where the optimizer found no finite motion @param unit of the speed
std::vector<std::string> infeasible_reasons(bool usable, const PlanQuality& quality,
                                            const std::string& unit);

}  // namespace legwright
