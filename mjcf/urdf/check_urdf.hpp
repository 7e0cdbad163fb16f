// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// Looks at each <link>, <joint> and <material> of a URDF with what stands in them (UrdfElement):
/// numbers that are none or too many, what must be there and is not, what is there twice, types of
/// joints, and words that are slips of those that are read, which would be passed over. Words that
/// are near to none are somebody's extension. What MuJoCo's reader takes with a meaning passes:
/// empty attributes, <limit> of fixed joints, second shapes, infinite limits.
void check_urdf(const XmlFile& urdf, Refusals& faults);

/// A reason at an attribute of an element, in the line where that stands, which may be below that
/// of the element's tag. @param where the link or joint that has the element
InputError urdf_fault(const XmlFile& urdf, const XmlElement& element, const char* attribute,
                      const XmlElement& where, const std::string& message);

}  // namespace legwright
