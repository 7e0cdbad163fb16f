// SPDX-License-Identifier: Apache-2.0
#include "tools/run/numerics_record.hpp"

namespace legwright {
namespace {

/// A number of a run; null where it could not be measured.
using Number = std::optional<double>;

Number difference(const Number& a, const Number& b) {
  return a && b ? Number(*a - *b) : std::nullopt;
}

}  // namespace

NumericsNumbers numbers_of(const RolloutMetrics& m) {
  return {m.speed_ratio, m.turn_ratio, m.tilt_max, m.heading_drift, m.torque_rms};
}

NumericsNumbers operator-(const NumericsNumbers& a, const NumericsNumbers& b) {
  return {difference(a.speed_ratio, b.speed_ratio), difference(a.turn_ratio, b.turn_ratio),
          difference(a.tilt_max, b.tilt_max), difference(a.heading_drift, b.heading_drift),
          difference(a.torque_rms, b.torque_rms)};
}

void fields(Fields& f, NumericsNumbers& numbers) {
  f.nullable("speed_ratio", numbers.speed_ratio);
  f.nullable("turn_ratio", numbers.turn_ratio);
  f.nullable("tilt_max_rad", numbers.tilt_max);
  f.nullable("heading_drift_rad", numbers.heading_drift);
  f.nullable("torque_rms_Nm", numbers.torque_rms);
}

void fields(Fields& f, NumericsRun& run) {
  f("name", run.name);
  f("label", run.label);
  std::optional<std::string> gains;
  if (!run.gains.empty()) gains = run.gains;
  f("gains", gains, "of the servos: \"half\", \"default\", \"double\"");
  if (f.reads()) run.gains = gains.value_or("");
  f("timestep_s", run.timestep);
  f("integrator", run.integrator);
  f("cone", run.cone);
  f("pass", run.pass);
  f("line", run.line);
  fields(f, run.numbers);
  f.nullable("difference", run.difference,
             "from the reference of its gains, which is the scene as it is");
}

void fields(Fields& f, NumericsRecord& numerics) {
  f("runs", numerics.runs, "of each gain the first is the reference, the scene as it is");
  f("agree", numerics.agree);
  f("reasons", numerics.reasons, "which run disagrees, and how");
  of_field(f, numerics.of);
}

}  // namespace legwright
