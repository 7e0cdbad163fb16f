// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "tools/run/run_record.hpp"

namespace legwright {

/// What MuJoCo said of a gait before or after the physics steps.
struct GapSide {
  bool pass = false;
  std::string words;
};
/// What `optimize --physics-steps` did, in words.
struct GapView {
  bool changed = false;  // else no step was confirmed
  std::string factors;   // "speed × 1.012, swing height × 1.05"
  GapSide before, after;
  std::size_t steps = 0, confirmed = 0;
};
/// Nothing where there were no such steps.
std::optional<GapView> gap_of(const RunRecord& run);
/// Whether the result of a run, or of one of its tasks, is another gait than that of its F, terms
/// and certificate, which belong to the last iteration.
bool gait_was_stepped(const TaskRecord& task);
bool gait_was_stepped(const RunRecord& run);

}  // namespace legwright
