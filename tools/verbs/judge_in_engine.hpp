// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/run/engine_record.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/validate/other_engine.hpp"

namespace legwright {

/// A physics engine that plays a result.
struct Engine {
  std::string name, version;  // "drake", "1.51.1"
  EngineStart start;          // without it MuJoCo plays, with the plugin
};

struct EngineOptions {
  int cycles = 20;
  std::vector<double> gain_scales = {0.5, 1.0, 2.0};
  std::filesystem::path limits;     // a limits file; empty: what holds by default
  bool write = false;               // the record, into result/, which is locked meanwhile
  std::function<bool()> stop = {};  // asked while it plays; RolloutStopped where it says so
};

/// Plays the result of a run of one task in an engine, at each gain, and judges it by the measures
/// and limits of `legwright validate`; disturbances, other numerics and the plan against physics
/// are MuJoCo's alone. Throws InputError for a scene that cannot be played, and for limits that
/// need what is not played here; IoError where there is no scene; std::invalid_argument for gains
/// or cycles of which there are none.
EngineRecord judge_in_engine(const ResultFolder& folder, const Engine& engine,
                             const EngineOptions& options);

}  // namespace legwright
