// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/robot_model.hpp"
#include "mjcf/text/robot_files.hpp"

namespace legwright {

/// Bodies whose <inertial> cannot be that of their shape, as exporters of CAD programs leave them
/// in other units or frames: a centre of mass far beside what the body shows and collides with, or
/// moments of inertia of a much larger one. A sentence for each kind, the worst body first.
std::vector<std::string> doubtful_masses(const RobotModel& robot);
/// The same of a robot that may be refused as one. Faults of the file are left to its reader.
std::vector<std::string> doubtful_masses(const RobotFiles& files);

/// The bodies among them whose moments of inertia are those of a much larger one, by name.
std::vector<std::string> wide_inertias(const RobotModel& robot);

}  // namespace legwright
