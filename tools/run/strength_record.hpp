// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/run/record.hpp"

namespace legwright {

/// A printed part under one kind of load.
struct PartStrength {
  std::string part;                    // after the first link that has it
  std::string load;                    // "bears the gait"
  std::optional<double> factor;        // strength over the largest stress; null: not judged
  std::optional<double> least_factor;  // that passes
  std::string where;                   // stressed most, and when; or why it was not judged
  bool pass = false;
};

/// result/strength.json of a run with the masses of its printed parts: whether these bear the gait.
struct StrengthRecord {
  static constexpr RecordKind kKind{"legwright/strength", 1, "parts"};
  double strength = 0.0;  // of the printed material across its layers [MPa]
  std::vector<PartStrength> parts;
};

void fields(Fields& f, StrengthRecord& strength);

}  // namespace legwright
