// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "mjcf/read/structure.hpp"
#include "mjcf/shape/affine.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// Geoms of the trunk and of a limb that can meet.
struct GeomPair {
  int trunk, limb;
  // How much nearer the shapes are than their capsules, in the home pose of the file [m].
  double hidden;
};

/// What stands for the shapes of trunk and limbs that can meet.
struct TrunkCapsules {
  std::map<int, std::vector<Capsule>> of_geom;  // in the frame of its body; link is left open
  std::vector<GeomPair> pairs;                  // rising
};

/// Covers the geoms of the pairs that can collide (`trunk_collisions`, `capsules_of`). Capsules
/// within hulls leave out what is beside them: pairs with a mesh are measured against the hulls as
/// MuJoCo finds them in the home pose of the file; pairs whose hulls touch there are left out, as
/// no plan parts them.
/// @param stretches_of by body id. @param initial the design of the file. @param length of a leg
/// [m].
TrunkCapsules trunk_capsules(const XmlFile& xml, const TreeElements& elements, const mjModel& model,
                             const Structure& structure,
                             const std::function<const std::vector<Stretch>&(int)>& stretches_of,
                             const Eigen::VectorXd& initial, double length);

}  // namespace legwright
