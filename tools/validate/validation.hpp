// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/simulate/rollout.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/measure.hpp"
#include "tools/validate/stage_progress.hpp"
#include "tools/validate/verdict.hpp"

namespace legwright {

/// A scene to be played, and what its plan reached [m/s, heading frame]; zero if unknown.
struct SceneToValidate {
  std::filesystem::path scene;
  Eigen::Vector2d plan_velocity = Eigen::Vector2d::Zero();
  std::vector<std::string> joints = {};  // that the plan moves, in its order; empty: not compared
};

struct ValidationOptions {
  int cycles = 20;
  std::vector<double> gain_scales = {0.5, 1.0, 2.0};
  int threads = 2;
  double frames_until = 4.0;     // of the recorded motion at default gains [s]
  double frame_interval = 0.01;  // [s]
  Limits limits = default_limits();
  ProgressListener progress = {};
};

/// What became of one scene.
struct SceneValidation {
  std::vector<Measurements> at_gains;  // in the order of gain_scales
  Verdict verdict;
  std::vector<std::string> qpos_names;   // with units, of the frames
  std::vector<RolloutFrame> frames;      // at default gains
  std::optional<Comparison> comparison;  // with the plan, at default gains; none for an early fall
  double timestep = 0.0;                 // [s]
  double robot_mass = 0.0;               // [kg]
  std::vector<std::string> never_touch;  // links_that_never_touch()
  int links = 0;                         // link_count()
};

/// Plays each scene at each gain and judges it. Results do not depend on the number of threads.
/// Throws MujocoError for a scene that cannot be played, std::system_error where a file cannot be
/// read.
std::vector<SceneValidation> validate_scenes(const std::vector<SceneToValidate>& scenes,
                                             const WantedMotion& wanted, const std::string& gait,
                                             const ValidationOptions& options = {});

/// What was measured at default gains, if they were played.
std::optional<Measurements> at_default_gains(const SceneValidation& validation);

/// The frames as a table: time_s and every entry of qpos by name, in plain decimals.
std::string playback_csv(const SceneValidation& validation);

}  // namespace legwright
