// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"

namespace legwright {

/// Writes urdf/NAME.urdf and its meshes beside it. Throws InputError for a robot that URDF cannot
/// express, IoError where the robot has a file of its own there. @return what URDF cannot say
std::vector<std::string> write_urdf(const RobotModel& robot, const std::filesystem::path& folder,
                                    const std::string& name);

/// Writes ros/PACKAGE, a ROS 2 package: the URDF, each gait of the run as a JointTrajectory, a node
/// that publishes it and a launch file. Throws as write_urdf(). @return the package's name
std::string write_ros(const RobotModel& robot, const std::filesystem::path& run,
                      const std::filesystem::path& folder, const std::string& name);

}  // namespace legwright
