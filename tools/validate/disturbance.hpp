// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "tools/simulate/rollout.hpp"
#include "tools/simulate/scene.hpp"

namespace legwright {

/// What the world or the robot differs in from what was planned (README.md says how each is done).
/// Everything but the friction is nothing at its default.
struct Disturbance {
  double floor_friction = 0.8;  // of the contacts between feet and floor
  double mass_scale = 1.0;      // of all bodies, with their inertia
  double gain_scale = 1.0;      // kp × scale, kd × √scale
  double delay = 0.0;           // from the state that a servo measures to its torque [s]
  double roll = 0.0;            // of the whole robot at the start, about where it faces [rad]
  double pitch = 0.0;           // nose down [rad]
  double push_forward = 0.0;    // impulse on the trunk over the robot's mass, as it faces [m/s]
  double push_left = 0.0;       // [m/s]
  double slope_along = 0.0;     // of the floor, uphill the way it shall go at the start [rad]
  double slope_across = 0.0;    // rising to the left of that way [rad]
  double ground_sink = 0.0;  // how deep feet sink in under the standing weight [m]; 0: the scene's
};

/// Late servos in steps of the scene, or in finer ones where the delay is what is looked for:
/// chatter depends on the step.
enum class DelayStep { scene, fine };

/// A scene to be played under disturbances. Immutable; any number of threads may use it at once.
class DisturbableScene {
 public:
  /// @param way direction of the wanted travel, heading frame; zero is taken for forward
  /// @param forward where the robot faces in that frame. Throws as load_scene.
  DisturbableScene(const std::filesystem::path& file, const Eigen::Vector2d& way,
                   const Eigen::Vector2d& forward = Eigen::Vector2d::UnitX());

  const Scene& undisturbed() const { return scene_; }
  /// Nothing but the scene's own friction of the floor.
  Disturbance nothing() const;
  /// A copy for one roll-out, whose model is changed; compiled anew where the gains are.
  Scene with(const Disturbance& disturbance, DelayStep delay_step = DelayStep::scene) const;

 private:
  std::string xml_;
  std::filesystem::path folder_;
  Eigen::Vector2d way_;
  Scene scene_;
};

/// What changes the state and acts on the robot while it walks: initial tilt, push and delay. Its
/// trunk starts at rest, set down by hand: on ice a robot would keep the speed of its plan for
/// ever.
/// @param scene made by DisturbableScene::with from the same disturbance; outlives the options and
/// serves one roll-out @param push_time [s] @param forward where it faces, heading frame
RolloutOptions disturbed_rollout(Scene& scene, const Disturbance& disturbance, int cycles,
                                 double push_time,
                                 const Eigen::Vector2d& forward = Eigen::Vector2d::UnitX());

}  // namespace legwright
