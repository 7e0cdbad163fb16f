// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

namespace legwright {

/// Puts the convex hull of each mesh file in the place of its triangles: of a model that nobody
/// looks at. MuJoCo collides hulls of meshes anyway, and places a mesh by the second moments of its
/// volume, which the new one has, too; so shapes, masses and frames stay, to what MuJoCo's single
/// precision of vertices leaves. Compiling then takes milliseconds where it took seconds.
///
/// A file is read once in a process, as long as it does not change. As they are stay meshes without
/// a file, those that give a body its mass, those whose triangles count otherwise (a primitive
/// fitted to them, a signed distance, the ellipsoids of a fluid, a limit to the hull's corners),
/// and those that MuJoCo refuses by themselves: of these the compiler tells why.
/// @param spec as it was parsed, with its modelfiledir
void put_hulls_for_meshes(mjSpec& spec);

}  // namespace legwright
