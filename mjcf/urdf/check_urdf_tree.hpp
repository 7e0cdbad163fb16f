// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// Looks at how the joints of a URDF hold its links together: links that are not there, two of one
/// name, those that hang on two joints, and circles. A <mimic> of a joint that is not there is
/// refused where one has nearly its name; else MuJoCo's reader passes it over.
void check_urdf_tree(const XmlFile& urdf, Refusals& faults);

}  // namespace legwright
