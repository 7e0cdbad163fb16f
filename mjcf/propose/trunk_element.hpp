// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/text/robot_files.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// Whether an element is a free joint by its own words, not by those of a <default>.
bool is_free_joint(const XmlElement& element);

/// The body of a file that has a free joint and hinges, or included files, below it, as trunk_of()
/// finds it in a model. Nothing where an included file has it: what floats besides has no hinges.
const XmlElement* trunk_element(const XmlFile& xml);

/// A robot whose trunk has no name, called "trunk", or "trunk_2" where another body is.
/// All other bytes stay, and all of them where it has one or the main file does not hold it.
/// @param name what it is called then; empty where nothing was done
RobotFiles with_named_trunk(const RobotFiles& files, std::string* name);

}  // namespace legwright
