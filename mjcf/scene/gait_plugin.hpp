// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace legwright {

/// Name under which MuJoCo knows the plugin that plays gaits.
inline constexpr const char* kGaitPlugin = "legwright.gait";

}  // namespace legwright
