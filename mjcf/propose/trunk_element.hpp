// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/text/robot_files.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

bool is_free_joint(const XmlElement& element);

/// The body of a file that has the robot's free joint, as trunk_of() finds it in a model: the first
/// with hinges below it, else the first. Nothing where an included file has it.
const XmlElement* trunk_element(const XmlFile& xml);

/// A robot whose trunk has no name, called "trunk", or "trunk_2" where another body is.
/// All other bytes stay, and all of them where it has one or the main file does not hold it.
/// @param name what it is called then; empty where nothing was done
RobotFiles with_named_trunk(const RobotFiles& files, std::string* name);

}  // namespace legwright
