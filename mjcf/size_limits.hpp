// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mjcf/xml.hpp"

namespace legwright {

/// Numbers by which a small file asks MuJoCo for much memory or time: tables of <size>, iterations
/// of <option>, finely cut drawings of <visual>. Throws InputError at the element.
void check_sizes(const XmlFile& xml, const XmlElement& element);

}  // namespace legwright
