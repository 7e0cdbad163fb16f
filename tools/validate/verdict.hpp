// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/validate/limits.hpp"
#include "tools/validate/measure.hpp"

namespace legwright {

struct Verdict {
  bool pass = false;
  std::string line;                  // for a terminal: "PASS  walk sideways at 0.100 m/s: …"
  std::vector<std::string> reasons;  // why it fails, first cause first; empty if it passes
  std::vector<JudgedLimit> limits;   // all that was judged; it passes when they all do
};

/// Judges one robot by its roll-outs at several gains. A number that is missing or is not a number
/// never passes.
/// Of a robot that fell or flew apart nothing else is told: the rest follows from it.
/// @param gait its name, for the line. @param further what was judged elsewhere: robustness,
/// numerics. Throws std::invalid_argument for no roll-out at all.
Verdict judge(const std::vector<Measurements>& at_gains, const WantedMotion& wanted,
              const std::string& gait, const Limits& limits = default_limits(),
              const std::vector<JudgedLimit>& further = {});

/// "walk sideways at 0.100 m/s": what is asked for, in words.
std::string describe(const WantedMotion& wanted, const std::string& gait);

}  // namespace legwright
