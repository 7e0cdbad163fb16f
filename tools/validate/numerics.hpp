// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/run/numerics_record.hpp"
#include "tools/validate/validation.hpp"

namespace legwright {

/// How MuJoCo computes; what is absent stays as the scene has it.
struct NumericalSetting {
  std::string name, words;  // "fine_step", "at 0.5 ms"
  std::optional<double> timestep;
  std::optional<int> integrator, cone;  // mjtIntegrator, mjtCone
  std::optional<double> impratio;
};

/// Half and a quarter of the step; implicit; a pyramidal cone, with impratio 1: higher
/// ones belong to elliptic cones.
/// @param timestep of the scene [s]
std::vector<NumericalSetting> other_numerics(double timestep);

/// The compiled scene with other options; nothing is written.
void apply(const NumericalSetting& setting, mjOption& options);

/// One way to compute, and what came out of it.
struct NumericalRun {
  std::string name, label, words;  // "reference", "1 ms, implicitfast, elliptic cone", ""
  double gain_scale = 1.0;
  double timestep = 0.0;  // [s]
  std::string integrator, cone;
  Measurements measured;
  Verdict verdict;
};

/// Whether the verdict hangs on how MuJoCo computes.
struct SecondOpinion {
  /// At default gains first, then the others; of each gain the first is the reference, the scene
  /// as it is.
  std::vector<NumericalRun> runs;
  bool agree = true;
  std::vector<std::string> reasons;  // which run disagrees, and how
};

/// Plays the scene at all gains as it is and with other numerics, and judges each run alone.
/// Results do not depend on the number of threads. Throws MujocoError for a scene that cannot be
/// played, std::system_error where a file cannot be read.
/// @param references what was measured in the scene as it is; a gain that is not there is played
/// @param settings empty: other_numerics of the scene
SecondOpinion second_opinion(const SceneToValidate& scene, const WantedMotion& wanted,
                             const std::string& gait, const ValidationOptions& options = {},
                             const std::vector<Measurements>& references = {},
                             std::vector<NumericalSetting> settings = {});

/// One line: "numerics: same verdict at 0.5 ms, with implicit, with a pyramidal cone, at half,
/// default and double gains (…)".
std::string describe(const SecondOpinion& opinion);

}  // namespace legwright
