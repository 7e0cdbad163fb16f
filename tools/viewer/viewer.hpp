// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace legwright {

struct ViewerOptions {
  std::filesystem::path path;  // a scene, or the folder of a run to follow
  bool follow = false, paused = false;
  bool ghost = false;  // show the planned robot from the start; key 5 does it later
  std::function<void(const std::string&)> say;  // receives what was loaded, and what went wrong
};

/// Opens MuJoCo's viewer and comes back when its window is closed. A gait starts in its first pose,
/// also after Reset, and the camera goes along. A scene that cannot be loaded is reported in the
/// window, and the one before stays. Throws MujocoError where there is no display or no OpenGL,
/// PluginError where the plugin is missing.
void view(const ViewerOptions& options);

}  // namespace legwright
