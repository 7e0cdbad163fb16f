// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "optimizer/solve/attribution.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {

/// run.json's "pull": {parameter: {term: decrease of F}}, of one task.
Json to_json(const std::vector<Attribution>& attributions);

/// The same read; what has another form is left out.
/// @param task that the shares are labelled with; may be empty
std::vector<Attribution> attributions_from_json(const Json& pull, const std::string& task = {});

}  // namespace legwright
