// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <string>
#include <vector>

#include "mjcf/read/structure.hpp"
#include "mjcf/shape/affine.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// The point masses of printed bodies, by MJCF name, in the body's frame.
using PrintedMap = std::map<std::string, std::vector<PointMass>>;

/// Masses of the stretched bodies that have no <inertial>: density times geometry of their geoms.
/// Boxes grow along their own axes, cylinders and capsules placed by `fromto` along theirs (the
/// round ends of a capsule do not), the rest keeps its size. A part's own `mass` stays, but for a
/// capsule that grows: that keeps its density, and its `mass` is rewritten. Exactly what MuJoCo
/// will compute of the rewritten file. A geom that would not keep its shape, and a body that MuJoCo
/// weighs otherwise, are reasons, for which the body is left out.
PrintedMap read_printed(const XmlFile& xml, const mjModel& model, const Structure& structure,
                        const StretchMap& stretches, Refusals& reasons);

}  // namespace legwright
