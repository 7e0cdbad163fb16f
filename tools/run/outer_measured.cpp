// SPDX-License-Identifier: Apache-2.0
#include "tools/run/outer_measured.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

ByName<double> by_gain(const std::string& objective, const ByName<GainMetrics>& gains) {
  ByName<double> out;
  for (const auto& [gain, metrics] : gains)
    if (const auto amount = measured_amount(objective, metrics)) out.of(gain) = *amount;
  return out;
}

}  // namespace

std::optional<double> measured_amount(const std::string& objective, const GainMetrics& metrics) {
  if (metrics.fall || metrics.diverged || metrics.cycles < 1) return std::nullopt;
  std::optional<double> out;
  if (objective == "peak_torque")
    for (const JointMetrics& joint : metrics.joints)
      out = std::max(out.value_or(0.0), joint.torque_peak);
  if (objective == "mechanical_work" && metrics.power_mean)
    out = *metrics.power_mean * metrics.seconds / metrics.cycles;
  return out && std::isfinite(*out) ? out : std::nullopt;
}

std::optional<OuterMeasured> outer_measured(const OuterRecord& outer,
                                            const MetricsRecord& metrics) {
  if (outer.source) return std::nullopt;  // whatever its name is
  OuterMeasured out{by_gain(outer.objective, metrics.initial),
                    by_gain(outer.objective, metrics.result)};
  if (out.initial.empty() && out.result.empty()) return std::nullopt;
  return out;
}

}  // namespace legwright
