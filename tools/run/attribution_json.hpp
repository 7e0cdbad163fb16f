// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "optimizer/solve/attribution.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {

/// run.json's "pull", of one task.
AttributionRecord record_of(const std::vector<Attribution>& attributions);

/// The same read, largest shares first; none where the run has none.
/// @param task that the shares are labelled with; may be empty
std::vector<Attribution> attributions_of(const std::optional<AttributionRecord>& pull,
                                         const std::string& task = {});

}  // namespace legwright
