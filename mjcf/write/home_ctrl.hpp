// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mjcf/text/robot_files.hpp"

namespace legwright {

/// The controls with which position servos hold a pose: where they are, within their ranges; 0 for
/// other actuators. Nothing where there is no position servo.
/// @param qpos nq numbers. @param file for messages
std::optional<std::vector<double>> holding_ctrl(const mjModel& model, const mjtNum* qpos,
                                                const std::filesystem::path& file);

/// Such numbers as an attribute of a <key>.
std::string ctrl_text(const std::vector<double>& ctrl);

/// A robot whose home keyframe has a qpos and no ctrl with the controls that hold it there; stock
/// MuJoCo would tell its servos 0. Any other robot as it is.
RobotFiles with_home_ctrl(const RobotFiles& files);

}  // namespace legwright
