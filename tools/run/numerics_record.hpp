// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/run/metrics_record.hpp"
#include "tools/run/record.hpp"

namespace legwright {

/// What is compared between ways to compute; null where it could not be measured.
struct NumericsNumbers {
  std::optional<double> speed_ratio, turn_ratio;
  std::optional<double> tilt_max, heading_drift;  // [rad]
  std::optional<double> torque_rms;               // [N m]
};

/// What is told of a roll-out, and by how much two of them differ.
NumericsNumbers numbers_of(const RolloutMetrics& measured);
NumericsNumbers operator-(const NumericsNumbers& a, const NumericsNumbers& b);

/// The gait played with one time step, integrator and model of friction.
struct NumericsRun {
  std::string name, label;  // "half_step", "0.5 ms, implicitfast, elliptic cone"
  std::string gains;        // "half"; empty in older files: the default ones
  double timestep = 0.0;    // [s]
  std::string integrator, cone;
  bool pass = false;
  std::string line;
  NumericsNumbers numbers;
  std::optional<NumericsNumbers> difference;  // from the reference of its gains, which has none
};

/// result/numerics.json: whether the verdict hangs on how MuJoCo computes.
struct NumericsRecord {
  static constexpr RecordKind kKind{"legwright/numerics", 1, "validate"};
  std::vector<NumericsRun> runs;  // of each gain the first is the scene as it is
  bool agree = true;
  std::vector<std::string> reasons;  // which run disagrees, and how
  std::optional<JudgedSums> of = {};
};

void fields(Fields& f, NumericsRecord& numerics);

}  // namespace legwright
