// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// The end of a walk.
struct Fall {
  double time = 0.0;  // [s]
  std::string cause;  // "tilted by more than 1 rad", …
};

/// A kind of warning that MuJoCo counts.
struct HealthWarning {
  double time = 0.0;  // of the first [s]
  std::string text;
  int count = 0;
};

}  // namespace legwright
