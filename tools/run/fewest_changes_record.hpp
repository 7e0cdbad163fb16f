// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/run/played_gait.hpp"
#include "tools/run/record.hpp"

namespace legwright {

/// A design of which only some parameters differ from the initial body's.
struct FewerChangesRecord {
  std::vector<std::string> changed;
  double F = 0.0;  // Σ weight (F + J)
  ByName<double> s;
  std::optional<PlayedGait> played = {};  // up to the first gain at which it fails
};
void fields(Fields& f, FewerChangesRecord& design);

/// With how few changes of the body F falls how far.
struct FewestChangesRecord {
  double share = 0.0;      // of the fall of F that is to be kept
  double initial_F = 0.0;  // of the initial body, counted as that of the designs
  std::size_t fewest = 0;  // of `designs`: the last that keeps it
  bool kept = false;       // whether that design is the result of the run
  double seconds = 0.0;
  std::vector<FewerChangesRecord> designs;  // from all changes to one
};
void fields(Fields& f, FewestChangesRecord& fewest);

/// The least changed of the designs that MuJoCo passes; null where it passes none or was not asked.
const FewerChangesRecord* least_that_passes(const FewestChangesRecord& fewest);

}  // namespace legwright
