// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "tools/run/metrics_record.hpp"
#include "tools/run/verdict_record.hpp"

namespace legwright {

/// result/validation_drake.json: what the result does in another engine than MuJoCo, with the
/// measures and limits of metrics.json and verdict.json.
struct EngineRecord {
  static constexpr RecordKind kKind{"legwright/engine_validation", 1, "validate --engine drake"};
  std::string engine, version;               // "drake", "1.51.1"
  std::string task;                          // "trot forward at 0.100 m/s"
  int cycles = 0;                            // of each roll-out
  double timestep = 0.0;                     // of what was measured [s]
  std::map<std::string, LimitRange> limits;  // by which it was judged
  ByName<std::string> versions;
  ByName<bool> passes;  // by servo gains: the verdict on that roll-out alone
  DesignVerdict verdict;
  ByName<GainMetrics> result;
  std::optional<JudgedSums> of = {};
};

void fields(Fields& f, EngineRecord& record);

/// The engine that the program knows besides MuJoCo.
inline constexpr const char* kDrake = "drake";
/// Where a run's result/ has it.
std::string engine_file(const std::string& engine);

}  // namespace legwright
