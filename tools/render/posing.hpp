// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <span>

#include "mjcf/text/mujoco_pointers.hpp"

namespace legwright {

inline constexpr double kFieldOfView =
    24.0;  // [deg], vertical: a little telephoto, so that links keep their proportions

// [deg] An oblique view of a robot that stands: from ahead, to one side and above.
inline constexpr double kObliqueAzimuth = 215.0, kObliqueElevation = -16.0;

/// Puts the model in a pose: positions of everything that is drawn, no dynamics (so no solver, no
/// warnings, no plugin call). Throws std::invalid_argument for a qpos of the wrong size or with
/// non-finite numbers.
void place(const mjModel& model, mjData& data, std::span<const double> qpos);

}  // namespace legwright
