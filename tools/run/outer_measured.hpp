// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tools/run/metrics_record.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {

/// The quantity of an outer objective in a roll-out: "peak_torque" the largest torque of any servo
/// after the first cycle [N m], "mechanical_work" the positive work of all servos in a cycle [J].
/// Nothing where the robot fell, and for what is no matter of motion.
std::optional<double> measured_amount(const std::string& objective, const GainMetrics& metrics);

/// The same of both designs at all gains. Nothing where a roll-out cannot tell, as of a function of
/// the caller's.
std::optional<OuterMeasured> outer_measured(const OuterRecord& outer, const MetricsRecord& metrics);

}  // namespace legwright
