// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// A design parameter that a robot could declare: the pair <numeric>, <text> of its <custom>
/// section.
struct Proposal {
  std::string name;
  double value = 0.0, lower = 0.0, upper = 0.0;
  std::string unit, binding, sentence;
};

}  // namespace legwright
