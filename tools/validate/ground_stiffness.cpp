// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/ground_stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "tools/validate/floor_friction.hpp"

namespace legwright {
namespace {

double inverse_mass_of_feet(const Scene& scene) {
  const mjModel& model = *scene.model;
  double sum = 0.0;
  for (const int foot : scene.foot_geom)
    sum += model.body_invweight0[static_cast<std::ptrdiff_t>(2) * model.geom_bodyid[foot]];
  return sum / static_cast<double>(scene.foot_geom.size());
}

}  // namespace

double planted_load(const Scene& scene) {
  const Trajectory& plan = scene.trajectory;
  int planted = 0, knots = 0;
  for (int knot = 0; knot < plan.knot_count; ++knot) {
    int here = 0;
    for (int foot = 0; foot < plan.foot_count(); ++foot)
      here += plan.at(knot, plan.contact_column(foot)) > 0.5 ? 1 : 0;
    planted += here;
    knots += here > 0 ? 1 : 0;
  }
  return robot_weight(*scene.model, scene.joints) * knots / std::max(1, planted);
}

double contact_time_for(const Scene& scene, double sink) {
  constexpr double d = kSoftImpedance;
  return std::sqrt(sink * d * d / ((1.0 - d) * inverse_mass_of_feet(scene) * planted_load(scene))) /
         d;
}

void soften_ground(Scene& scene, double sink) {
  mjModel& model = *scene.model;
  const double time = contact_time_for(scene, sink);
  const auto soften = [&](int geom) {
    mjtNum* const reference = model.geom_solref + static_cast<std::ptrdiff_t>(mjNREF) * geom;
    mjtNum* const impedance = model.geom_solimp + static_cast<std::ptrdiff_t>(mjNIMP) * geom;
    if (reference[0] <= 0.0 || reference[0] >= time) return;  // in another unit, or softer
    reference[0] = time;
    reference[1] = 1.0;
    impedance[0] = impedance[1] = kSoftImpedance;
  };
  for (const Footing& footing : footings(scene))
    for (const int geom : {footing.ground, footing.foot})
      if (footing.ruling < 0 || geom == footing.ruling) soften(geom);
}

}  // namespace legwright
