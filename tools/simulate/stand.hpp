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
  double trunk_before = 0.0, trunk_after = 0.0;  // height of the body with the free joint [m]
};

/// Simulates a model as stock MuJoCo opens it: from its keyframe `home` (else its first, else the
/// reference pose), with that keyframe's controls. MuJoCo never resets it. The model must have no
/// plugin. Throws MujocoError where MuJoCo refuses the file.
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
