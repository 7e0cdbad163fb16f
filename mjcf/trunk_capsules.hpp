// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "mjcf/affine.hpp"
#include "mjcf/elements.hpp"
#include "mjcf/structure.hpp"
#include "mjcf/xml.hpp"

namespace legwright {

/// What stands for the shapes of trunk and limbs that can meet.
struct TrunkCapsules {
  std::map<int, std::vector<Capsule>> of_geom;  // in the frame of its body; link is left open
  std::vector<std::pair<int, int>> pairs;       // geoms (trunk, limb), rising
};

/// Covers the geoms of the pairs that can collide (`trunk_collisions`, `capsules_of`). Pairs with a mesh are fitted to
/// the home pose of the file: capsules within hulls leave out what is beside them, so those of a mesh are made as much
/// thicker as no pair that is near there gets nearer than MuJoCo finds its hulls; pairs whose hulls touch there are
/// left out, as no plan parts them.
/// @param stretches_of by body id. @param initial the design of the file. @param length of a leg [m].
TrunkCapsules trunk_capsules(const XmlFile& xml, const TreeElements& elements, const mjModel& model,
                             const Structure& structure,
                             const std::function<const std::vector<Stretch>&(int)>& stretches_of,
                             const Eigen::VectorXd& initial, double length);

}  // namespace legwright
