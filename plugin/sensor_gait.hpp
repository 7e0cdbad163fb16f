// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

namespace legwright {

/// The instance of legwright.gait that an instance of legwright.sensor looks at: the one that its
/// key `gait` names, else the only one, else the one of the robot it was attached with. Attaching
/// puts the same prefix and suffix round the names of sensor and gait, but not round the key: what
/// the gait's name has more than the key, the sensor's name must have too. Of several the one with
/// the most of it is meant, so that "a_b_" is not taken for "a_", nor "a_" for none.
/// Where none is found because a gait cannot be played, that gait: its own init tells the reason.
/// Throws ConfigError where there is none or no single one.
/// @param gait_slot slot of the plugin legwright.gait
int find_gait(const mjModel* m, int instance, int gait_slot);

}  // namespace legwright
