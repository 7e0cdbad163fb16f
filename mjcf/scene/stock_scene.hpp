// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace legwright {

/// The scene of a gait for a MuJoCo without the plugin: each actuator that legwright.gait drives
/// becomes a `<general>` with the servo's own bias, force = ctrl − kp L − kd dL/dt, so that who
/// writes ctrl = kp L* + kd dL*/dt + feed-forward plays what the plugin plays; Legwright's sensors
/// and extensions go, all else stays. Throws InputError for a text that is no scene of a gait.
/// @param name of the file, for messages
std::string stock_scene(const std::string& gait_scene, const std::string& name);

}  // namespace legwright
