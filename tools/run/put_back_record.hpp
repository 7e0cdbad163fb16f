// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tools/run/played_gait.hpp"
#include "tools/run/record.hpp"

namespace legwright {

/// The result with one changed parameter at its old value, the motion solved anew.
struct PutBackRecord {
  std::string parameter;
  double F = 0.0;                 // there, less that of the result; not finite: no motion
  std::optional<double> J;        // the same, of a run with an outer objective
  ByName<double> terms, F_tasks;  // the same of each term; of a joint run instead of each task
  std::string status;             // of the motion
  std::optional<PlayedGait> played = {};  // up to the first gain at which it fails
};
void fields(Fields& f, PutBackRecord& row);

}  // namespace legwright
