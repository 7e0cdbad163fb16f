// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/simulate/health.hpp"

namespace legwright {

/// What became of a robot that was left to stand.
struct StandingResult {
  double seconds = 0.0;   // simulated
  bool diverged = false;  // a state that is no number: stopped there
  std::vector<HealthWarning> warnings;
  double trunk_before = 0.0, trunk_after = 0.0;  // trunk_com_height() [m]
  double highest = 0.0;                          // of it on the way [m]
  double sunk_in = 0.0;                          // how deep a geom starts in the ground [m]
  int servos = 0;               // position servos at joints and tendons: others hold no pose
  int commanded_elsewhere = 0;  // those whose command is not where they are

  /// Whether it stands as a robot does that is let go on its feet. Negations, so that NaN does not.
  bool sank() const { return !(trunk_after >= 0.9 * trunk_before); }
  bool flew() const { return !(highest <= 1.1 * trunk_before); }
  bool in_ground() const { return !(sunk_in <= 0.02 * trunk_before); }
};

/// Simulates a model as stock MuJoCo opens it: from the keyframe of its home pose (else its first,
/// else the reference pose), with that keyframe's controls. MuJoCo never resets it. The model must
/// have no plugin. Throws MujocoError where MuJoCo refuses the file.
StandingResult stand(const std::filesystem::path& scene, double seconds = 1.0);

/// Plays the gait of a design's scene from its start, for at least so long or until it falls.
/// @return what MuJoCo warned of. Throws MujocoError where it refuses the scene.
std::vector<HealthWarning> warnings_in_gait(const std::filesystem::path& scene,
                                            double seconds = 1.0);

/// What differs between a robot and a scene that includes it, element by element, in words; the
/// scene's own elements do not count. Throws MujocoError where MuJoCo refuses a file.
std::vector<std::string> differences_in_scene(const std::filesystem::path& robot,
                                              const std::filesystem::path& scene);

}  // namespace legwright
