// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/run/record.hpp"

namespace legwright {

/// How far MuJoCo let a gait come: of a candidate, of a design beside the result, or of a physics
/// step.
struct PlayedGait {
  double merit = 0.0;  // not finite: it fell
  bool pass = false;
  std::string line;  // of the verdict
};
void fields(Fields& f, PlayedGait& gait);

}  // namespace legwright
