// SPDX-License-Identifier: Apache-2.0
// Modules that stand inside each other: a battery in a servo, two servos in one place.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// Two modules of a robot whose outlines are inside each other in its home pose, on one body or
/// two.
struct ModuleOverlap {
  std::string first, second;  // bodies, of feet geoms: "part_1_lipo_3s_2200", "FL_hip_servo"
  double depth = 0.0;         // by which one would have to move, at least [m]
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();  // that way, in the world; either sign
  bool is_deep = false;  // the middle of one is in the other; of no trunk, a tray
};

/// Least depth of those that are told [m]: outlines are boxes around what has ridges and screws.
inline constexpr double kToldOverlap = 5e-4;

/// Those that are deeper, in the order of the file. The trunk is a tray: what stands or rides on it
/// may be in it; nothing else may. None of robots that were not built of modules. Throws InputError
/// at `file` where the engine fails.
std::vector<ModuleOverlap> module_overlaps(const mjModel& model, const std::filesystem::path& file);

/// "1.2 mm inside", with the other's name in between, and "along x" where that is the way.
std::string depth_words(const ModuleOverlap& overlap, const std::string& other);

/// What there is to say of those of a robot: a sentence with the cure; none where there are none.
std::vector<std::string> overlapping_modules(const RobotModel& robot);

}  // namespace legwright
