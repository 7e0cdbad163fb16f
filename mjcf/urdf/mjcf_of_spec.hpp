// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "mjcf/urdf/mend_urdf.hpp"

namespace legwright {

/// A robot as MuJoCo's reader holds it after reading a URDF, written as MJCF from its trunk on: all
/// digits of its numbers, names as they are, nothing that is a default. The trunk floats; joints
/// with a torque limit get position servos.
/// @param notes gets a sentence for what was added
std::string mjcf_of_spec(mjSpec& spec, mjsBody& trunk, const UrdfMending& mending,
                         std::vector<std::string>& notes);

}  // namespace legwright
