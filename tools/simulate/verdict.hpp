// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/simulate/measure.hpp"

namespace legwright {

/// What a robot must hold, at every gain it is played with, to pass.
struct VerdictLimits {
  double speed_ratio_low = 0.95;  // measured over planned speed, along the robot's heading
  double speed_ratio_high = 1.05;
  double tilt = 0.1;              // of the trunk, at any time [rad]
  double saturated_share = 1e-3;  // of the time after the first cycle; less counts as none
  double standing_speed = 0.01;   // where no travel is wanted: drift above it fails [m/s]
  double told_heading = 0.3;      // where it is too slow: trunk turned by more is told [rad]
  double turn_ratio_low = 0.9;    // measured over wanted turn rate, where turning is wanted
  double turn_ratio_high = 1.1;
};

struct Verdict {
  bool pass = false;
  std::string line;                  // for a terminal: "PASS  walk sideways at 0.100 m/s: …"
  std::vector<std::string> reasons;  // why it fails, first cause first; empty if it passes
};

/// Judges one robot by its roll-outs at several gains. A number that is missing or is not a number
/// never passes.
/// @param gait its name, for the line. Throws std::invalid_argument for no roll-out at all.
Verdict judge(const std::vector<Measurements>& at_gains, const WantedMotion& wanted,
              const std::string& gait, const VerdictLimits& limits = {});

/// "walk sideways at 0.100 m/s": what is asked for, in words.
std::string describe(const WantedMotion& wanted, const std::string& gait);

/// "half", "default", "double", or the number.
std::string gain_name(double scale);

}  // namespace legwright
