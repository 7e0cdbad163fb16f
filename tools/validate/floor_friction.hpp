// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "tools/simulate/scene.hpp"

namespace legwright {

/// A foot and a geom of the world that it can collide with: plane, box, height field, …
struct Footing {
  int ground = 0, foot = 0;  // geoms
  int ruling = -1;  // which of them says the friction of their contact; −1: the larger one counts

  double friction(const mjModel& model) const;
};

/// All of them, by contype and conaffinity; none where the feet meet nothing.
std::vector<Footing> footings(const Scene& scene);

/// Friction between the feet and the floor as MuJoCo mixes it: the geom of higher priority says it,
/// else the larger one counts. Of the slipperiest footing; infinite where there is none.
double floor_friction(const Scene& scene);

}  // namespace legwright
