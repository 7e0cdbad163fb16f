// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "mjcf/urdf/collada_meshes.hpp"
#include "mjcf/urdf/mend_urdf.hpp"

namespace legwright {

struct MjcfOfSpec {
  std::string text;
  /// Bodies with mass that have none, nor are given any: those of a small ball stand in.
  std::vector<std::string> without_moments;
};

/// A robot as MuJoCo's reader holds it after reading a URDF, written as MJCF from its trunk on: all
/// digits of its numbers, names as they are, nothing that is a default. The trunk floats; joints
/// with a torque limit get position servos, and the reflected inertia of those (kRotorTime).
/// @param collada whose files are written out @param notes gets a sentence for what was added
MjcfOfSpec mjcf_of_spec(mjSpec& spec, mjsBody& trunk, const UrdfMending& mending,
                        ColladaMeshes& collada, std::vector<std::string>& notes);

}  // namespace legwright
