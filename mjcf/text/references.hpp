// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "mjcf/text/xml.hpp"

namespace legwright {

/// Calls visit(attribute, name) for each attribute by which an element refers to another of a kind:
/// joint="…", site1="…", objname beside objtype. MuJoCo's XML reference has the attributes.
/// @param kind body, geom, site, joint, tendon, actuator, sensor, key, texture, material, …
void for_each_reference(const XmlElement& element, const std::string& kind,
                        const std::function<void(const char* attribute, const char* name)>& visit);

}  // namespace legwright
