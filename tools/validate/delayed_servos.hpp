// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

namespace legwright {

/// Steps a model whose servos act late: what pushes at time t is the force that the servo law gave
/// for state and target at t − delay. The plugin computes that force at every step; it waits in a
/// queue. Force limits of actuators and joints hold.
///
/// A step of h holds its force for h, so on average it is h/2 old already: the queue is read,
/// linearly interpolated, at t + h/2 − delay. Delays below h/2 act as h/2. Before there is a past,
/// the first force holds.
class DelayedServos {
 public:
  /// @param model kept, and changed by take_over @param delay [s], above 0
  DelayedServos(mjModel& model, double delay);

  /// Tells MuJoCo's implicit integrators nothing of the servos any more: a late force does not
  /// depend on the velocity of now. To be called after mjData is made and reset: the plugin wants
  /// the bias then.
  void take_over();
  /// As mj_step, with late forces.
  void step(mjData& data);

 private:
  void put_late_forces(mjData& data);

  mjModel& model_;
  double age_;                             // of the force that acts, in steps
  std::vector<std::vector<double>> past_;  // ring; past_[n % size] is of step n
  long long steps_ = 0;
};

}  // namespace legwright
