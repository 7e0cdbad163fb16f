// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/run/comparison_record.hpp"
#include "tools/run/metrics_record.hpp"
#include "tools/run/numerics_record.hpp"
#include "tools/run/robustness_record.hpp"
#include "tools/run/verdict_record.hpp"
#include "tools/validate/numerics.hpp"
#include "tools/validate/robustness.hpp"
#include "tools/validate/validation.hpp"

namespace legwright {

// What was measured and judged, as the files in result/ tell it.
/// What was measured at each of the gains, by their names.
ByName<GainMetrics> metrics_by_gain(const SceneValidation& validation);
DesignVerdict verdict_record(const Verdict& verdict);
/// The limits that the verdict was judged by.
std::map<std::string, LimitRange> limit_ranges(const Limits& limits);
/// SHA-256 of them, as judgements name it.
std::string limits_sum(const Limits& limits);
NumericsRecord numerics_record(const SecondOpinion& opinion);
RobustnessRecord robustness_record(const Robustness& robustness);
/// Absent where the robot fell before two cycles.
ComparisonRecord comparison_record(const std::optional<Comparison>& initial,
                                   const std::optional<Comparison>& result);

}  // namespace legwright
