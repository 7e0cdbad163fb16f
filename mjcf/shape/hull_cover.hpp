// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <vector>

namespace legwright {

/// A capsule within a convex hull, in the axes of its mesh [m].
struct HullCapsule {
  Eigen::Vector3d from, to;
  double radius;
};

/// At most so many capsules within the convex hull with which MuJoCo lets a mesh collide, none
/// beyond its faces, that together come near its surface everywhere: the first the one that fills
/// most, each further one that which best fills what the others leave, until no point looked at is
/// farther than `enough` from one of them. Corners and edges are looked at, too. None where the
/// mesh has no hull with room in it.
/// @param enough [m]
std::vector<HullCapsule> cover_hull(const mjModel& model, int mesh, int most, double enough);

}  // namespace legwright
