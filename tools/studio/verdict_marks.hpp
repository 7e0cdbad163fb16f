// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tools/files/json_file.hpp"
#include "tools/run/metrics_record.hpp"
#include "tools/run/verdict_record.hpp"

namespace legwright {

/// "; worst FL_knee (12 %) and FR_knee (11 %)"; empty where it passes, and where the value is the
/// whole robot's.
std::string failing_parts(const LimitRow& row);

/// What a line of the verdict marks on the robot, [{kind, name, words}]: the joints, feet or bodies
/// whose value it is; the "trunk" of a fall, a warning, and of what fails as a whole. Empty where
/// the whole robot passes.
Json marks_of(const LimitRow& row, const std::optional<MetricsRecord>& metrics);

}  // namespace legwright
