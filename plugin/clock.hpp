// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace legwright {

/// When the gait is where, as a function of `d->time` alone: nothing is counted between steps, so
/// that resets, scrubbing, sub-steps of RK4 and jumps of time need no care.
struct Clock {
  double t0 = 0.0;        // plan time at d->time = 0 [s]
  double speed = 1.0;     // plan seconds per second; 0 holds one pose, below 0 runs backwards
  double blend_in = 0.0;  // how long the way from rest into the gait takes [s]; 0: at once

  /// Plan time t0 + speed·time [s], at which the trajectory is looked up.
  double plan_time(double time) const noexcept { return t0 + speed * time; }
};

/// How much of the gait acts, and how fast that grows.
struct Blend {
  double share = 1.0;  // 0 at rest … 1 in the gait
  double rate = 0.0;   // its derivative [1/s]
};

/// w = 10x³ − 15x⁴ + 6x⁵ at x = time/blend_in, held at 0 before and at 1 after: its first two
/// derivatives are continuous. Without blend_in it is 1 always, also before time 0.
Blend blend_at(const Clock& clock, double time) noexcept;

}  // namespace legwright
