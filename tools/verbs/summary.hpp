// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "tools/run/run_record.hpp"

namespace legwright {

/// What `optimize` tells people at the end, from run.json.
std::string optimize_summary(const RunRecord& run, const std::filesystem::path& root);

/// The same for a run of several tasks.
std::string joint_summary(const RunRecord& run, const std::filesystem::path& root);

}  // namespace legwright
