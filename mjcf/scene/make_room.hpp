// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/text/xml.hpp"

namespace legwright {

/// A robot's text in which no element has a name by which others look up what a scene adds (key
/// "gait", sensors "tracking", "gait:KIND" and "contact:FOOT", sites "foot:FOOT", cameras "side"
/// and "track"): its own of these names become robot_NAME, and what refers to them follows. The
/// very same text where there is none. What is not looked up by its name (floor, its material,
/// payload) takes an unused_name() instead.
std::string make_room(const std::string& robot_xml, const std::filesystem::path& file);

}  // namespace legwright
