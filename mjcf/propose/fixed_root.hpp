// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "mjcf/text/robot_files.hpp"

namespace legwright {

/// The same robot with a free joint for a trunk that is drawn fixed to the world, as generators of
/// morphologies and models of controllers leave it: the one body in the world with limbs, two at
/// least that move on it. Keyframes keep the trunk where it is drawn. All other bytes stay, and
/// all of them where a body has a free joint, another or none is such a trunk, or the main file
/// does not hold it and all keyframes. Faults of the file are left to its reader.
/// @param told gets a sentence on the joint; empty where there is none
RobotFiles with_freed_trunk(const RobotFiles& files, std::string* told);

}  // namespace legwright
