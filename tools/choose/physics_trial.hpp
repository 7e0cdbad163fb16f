// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/simulate/scene.hpp"
#include "tools/task/task_file.hpp"
#include "tools/validate/measure.hpp"
#include "tools/validate/physics_steps.hpp"

namespace legwright {

/// The least that a missed limit adds to the distance from passing. A gait that fails in other
/// numerics alone stays below.
inline constexpr double kMissedLimit = 0.5;

/// Servo gains at which gaits are played, × those of the robot.
inline constexpr std::array<double, 3> kTrialGains = {0.5, 1.0, 2.0};

/// What physics says of a gait, for the choice between designs.
struct GaitTrial : PhysicsTrial {
  /// How far it is from passing: 0 where it passes; each limit that it misses at a gain adds one
  /// half and the logarithm of one plus the excess over the limit, in sizes of the limit. A fall
  /// adds ten times the share of the time that is missing.
  double distance = 0.0;
  double speed_ratio = 1.0;           // in the middle between the gains; 1 where unknown
  double heading_drift = 0.0;         // the same [rad a cycle]
  int rollouts = 0;                   // that it took
  std::vector<double> at_gains = {};  // what each of kTrialGains adds to `distance`
  std::string brief;                  // the first reason why it fails; empty where it passes
};

/// For how long a gait is played. One that fails within its first cycles fails; two that fail can
/// be compared only after as many.
enum class PlayedCycles { first, all };

/// The first cycles at one gain.
struct FirstCycles {
  Measurements measured;
  double planned_seconds = 0.0;
  double distance = 0.0;  // that it adds to the gait's
};

/// A planned gait that MuJoCo plays as `validate` does, judged by the same limits. Throws
/// MujocoError for a scene that cannot be played; needs load_gait_plugin() before.
class GaitOnTrial {
 public:
  /// @param wanted the task that it is judged by, which it need not be planned for; must outlive
  /// this @param stop where it says so, playing throws RolloutStopped
  GaitOnTrial(const RobotModel& robot, const TaskFile& wanted, DesignTexts texts,
              std::function<bool()> stop = {});

  /// At half, default and double gains; goes on from where an earlier call ended.
  /// @param threads of these; results do not depend on it
  GaitTrial play(PlayedCycles cycles, int threads = 1);
  /// The first cycles at one of kTrialGains. @param goes_on whether play() may go on from there;
  /// else the scene is given up
  FirstCycles play_first(std::size_t gain, bool goes_on);
  /// What such plays say together: at all gains what play(PlayedCycles::first) does.
  GaitTrial trial_of_first(const std::vector<FirstCycles>& runs) const;
  /// Adds to the trial of a gait that passes all cycles: plays them once more with those numerics
  /// in which such gaits fail most often: half the step at the highest gains, a pyramidal cone at
  /// these and the default ones (docs/findings/physics_in_the_search.md). A gait that fails in
  /// these alone is nearer to passing than any that misses a limit at its gains.
  void ask_other_numerics(int threads, GaitTrial& trial) const;
  /// Plays fewer cycles still, at double and half gains, up to the first at which it fails: of a
  /// design beside a result, which nobody hands back. Its distance is of the gains played.
  GaitTrial glance() const;
  /// The largest Floquet multiplier at the three gains (validate/floquet); infinite where the gait
  /// falls or diverges at one.
  double largest_multiplier(int threads) const;

 private:
  Scene scene(double gain) const;
  Measurements play(const Scene& scene, int cycles) const;
  bool begin(std::size_t gain);

  std::filesystem::path folder_;
  const TaskFile& wanted_;
  DesignTexts texts_;
  std::function<bool()> stop_;
  std::array<std::unique_ptr<const Scene>, kTrialGains.size()> scenes_;  // where begun
  std::array<std::unique_ptr<GaitMeasurement>, kTrialGains.size()> played_;
};

/// First cycles, all of them and other numerics, as far as the gait passes. Throws as GaitOnTrial.
GaitTrial try_in_physics(const RobotModel& robot, const TaskFile& wanted, const DesignTexts& texts);

}  // namespace legwright
