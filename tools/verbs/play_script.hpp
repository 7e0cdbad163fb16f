// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace legwright {

/// The text of play_gait.py, which `export` writes as play.py.
extern const char* const kPlayScript;
/// The texts of ros_play_gait.py and ros_walk.launch.py, which it puts into a ROS 2 package.
extern const char* const kRosNode;
extern const char* const kRosLaunch;

}  // namespace legwright
