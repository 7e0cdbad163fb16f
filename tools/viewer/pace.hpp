// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>
#include <simulate.h>

namespace legwright {

/// Keeps simulated time in step with the clock on the wall, at the speed that the viewer asks for.
class Pace {
 public:
  /// Steps until simulated time has caught up, but no longer than a part of a frame, so that the
  /// drawing thread gets its turn; pauses where the viewer pauses. With the viewer's lock held.
  void advance(mujoco::Simulate& viewer, const mjModel& model, mjData& data);

 private:
  using Clock = mujoco::Simulate::Clock;
  Clock::time_point wall_start_;
  double simulated_start_ = 0.0;
};

}  // namespace legwright
