// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "mjcf/read/structure.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// Why a robot does not stand on its feet in its home pose, in one sentence with the cure: they are
/// above its centre of mass, or something that collides and is no part of a leg reaches as low as
/// they do. Empty where it stands; balance is not looked at.
std::string why_not_standing(const XmlFile& xml, const mjModel& model, const Structure& structure);

}  // namespace legwright
