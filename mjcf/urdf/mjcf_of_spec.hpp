// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <string>
#include <vector>

#include "mjcf/urdf/collada_meshes.hpp"
#include "mjcf/urdf/mend_urdf.hpp"

namespace legwright {

/// Where the meshes of a spec come from.
struct MeshSources {
  ColladaMeshes& collada;
  std::map<std::string, std::string> path_of;  // of files that the spec calls otherwise
};

struct MjcfOfSpec {
  std::string text;
  /// Bodies with mass that have none, nor are given any: those of a small ball stand in.
  std::vector<std::string> without_moments;
};

/// A robot as MuJoCo's reader holds it after reading a URDF, written as MJCF from its trunk on: all
/// digits of its numbers, names as they are, nothing that is a default. The trunk floats; joints
/// with a torque limit get position servos, and the reflected inertia of those (kRotorTime).
/// @param meshes whose Collada files are written out
/// @param speeds limits of joints by name, which the spec does not hold (speed_limits())
/// @param notes gets a sentence for what was added
MjcfOfSpec mjcf_of_spec(mjSpec& spec, mjsBody& trunk, const UrdfMending& mending,
                        const MeshSources& meshes, const std::map<std::string, double>& speeds,
                        std::vector<std::string>& notes);

}  // namespace legwright
