// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "mjcf/shape/affine.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// How closely a shape is covered: each capsule of a trunk meets each of a limb at each knot, and
/// costs.
enum class CoverDetail {
  rough,   // limbs of a robot with many shapes, and its trunk where these are very many
  coarse,  // limbs: thin, edges may be rounded
  edges,   // the trunk: thick, and limbs pass close by its edges
};

/// The capsules that stand for a geom where it collides, as functions of the design, in the frame
/// of its body; link and part are left open. Spheres and capsules are themselves. A box, lying
/// cylinder or ellipsoid is a row of capsules along its longest side, as thick as it is, side by
/// side over its width, none beyond its faces; with `edges` a box thicker than `sharp` has a thin
/// one in each of its four long edges, too. A mesh is covered from within its convex hull
/// (`cover_hull`), closer than half of `sharp` where so many capsules do. Other types have none.
/// @param sharp [m]
std::vector<Capsule> capsules_of(const XmlFile& xml, const TreeElements& elements,
                                 const mjModel& model, int geom,
                                 const std::vector<Stretch>& stretches, double sharp,
                                 CoverDetail detail);

}  // namespace legwright
