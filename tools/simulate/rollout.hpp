// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/simulate/health.hpp"
#include "tools/simulate/scene.hpp"

namespace legwright {

/// One moment of a roll-out. All that MuJoCo derives from the state (xpos, contacts, forces,
/// actuator lengths and velocities) belongs to `time`; data.qpos and data.qvel are one step ahead
/// already.
struct RolloutSample {
  const mjModel& model;
  const mjData& data;
  double time;  // [s] since the start
};

/// When the robot is taken for fallen.
struct FallLimits {
  double tilt = 1.0;          // of the trunk's z axis from the vertical [rad]
  double height_share = 0.4;  // of trunk_com_height() at the start
};

/// Height of the trunk's centre of mass, with all that is fixed to it, above z = 0 [m]. The origin
/// of a trunk's frame may lie anywhere, also on the ground.
double trunk_com_height(const mjModel& model, const mjData& data, int root_body);

/// Whether the robot of a scene has fallen: its trunk, or what is fixed to it, touches the ground,
/// tilts or sank.
/// @param start_height trunk_com_height() at the start [m]
std::optional<Fall> find_fall(const Scene& scene, const mjData& data, double time,
                              double start_height, const FallLimits& limits);

/// The caller asked to stop in the middle of a roll-out.
struct RolloutStopped : std::exception {
  const char* what() const noexcept override { return "the roll-out was stopped"; }
};

struct RolloutOptions {
  int cycles = 20;
  FallLimits fall = {};
  double frame_interval = 0.01;     // of recorded frames [s]
  double frame_until = 0.0;         // record frames up to here [s]; 0: none
  std::function<bool()> stop = {};  // asked now and then; true: throws RolloutStopped
  // For disturbed roll-outs:
  std::function<void(mjData&)> prepare = {};       // changes the state at the keyframe
  std::function<void(mjData&, double)> step = {};  // does the work of mj_step, at this time [s]
};

struct RolloutFrame {
  double time;
  std::vector<double> qpos;
};

struct Rollout {
  double seconds = 0.0;  // simulated
  std::optional<Fall> fall;
  std::vector<HealthWarning> warnings;
  bool diverged = false;  // a state that is no number: stopped there
  std::vector<RolloutFrame> frames;
};

/// A roll-out of a scene that can be played on from where it stands: the same bits as in one go.
class ResumableRollout {
 public:
  /// Stands at the keyframe. Keeps a reference to the scene. @param options of which `cycles` does
  /// not count
  ResumableRollout(const Scene& scene, RolloutOptions options);

  /// Plays on until so many cycles since the start are whole; nothing where it stopped before.
  /// @return everything since the start
  const Rollout& play_to(int cycles, const std::function<void(const RolloutSample&)>& observe);

 private:
  bool play_step(const std::function<void(const RolloutSample&)>& observe);

  const Scene& scene_;
  RolloutOptions options_;
  DataPointer data_;
  Health health_;
  Rollout out_;
  long long next_ = 0;  // step
  double start_height_ = 0.0, next_frame_ = 0.0;
};

/// Plays a scene from its keyframe for whole cycles, headless, as fast as it goes. Stops early at a
/// fall or when the simulation diverges; MuJoCo never resets it. The same scene gives the same
/// bits.
/// @param observe called for each step with what holds at its beginning, and once for the end.
Rollout rollout(const Scene& scene, const RolloutOptions& options,
                const std::function<void(const RolloutSample&)>& observe = {});

}  // namespace legwright
