// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/floor_friction.hpp"

#include <algorithm>
#include <limits>

namespace legwright {
namespace {

bool meets(const mjModel& model, int a, int b) {
  return (model.geom_contype[a] & model.geom_conaffinity[b]) != 0 ||
         (model.geom_contype[b] & model.geom_conaffinity[a]) != 0;
}

int ruling_geom(const mjModel& model, int a, int b) {
  const int difference = model.geom_priority[a] - model.geom_priority[b];
  return difference > 0 ? a : difference < 0 ? b : -1;
}

}  // namespace

double Footing::friction(const mjModel& model) const {
  if (ruling >= 0) return model.geom_friction[3 * ruling];
  return std::max(model.geom_friction[3 * ground], model.geom_friction[3 * foot]);
}

std::vector<Footing> footings(const Scene& scene) {
  const mjModel& model = *scene.model;
  std::vector<Footing> out;
  for (int ground = 0; ground < model.ngeom; ++ground) {
    if (model.geom_bodyid[ground] != 0) continue;
    for (const int foot : scene.foot_geom)
      if (meets(model, ground, foot))
        out.push_back({ground, foot, ruling_geom(model, ground, foot)});
  }
  return out;
}

double floor_friction(const Scene& scene) {
  double least = std::numeric_limits<double>::infinity();
  for (const Footing& footing : footings(scene))
    least = std::min(least, footing.friction(*scene.model));
  return least;
}

}  // namespace legwright
