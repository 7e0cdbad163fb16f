// SPDX-License-Identifier: Apache-2.0
#include "plugin/ghost.hpp"

#include <algorithm>
#include <array>
#include <new>

#include "plugin/drawing.hpp"

namespace legwright {
namespace {

/// What is left of the model has no plugin: neither making data of it nor placing it calls one.
void remove_plugins(mjModel* m) {
  m->nplugin = 0;
  m->npluginstate = 0;
  std::fill_n(m->actuator_plugin, m->nactuator, -1);
  std::fill_n(m->sensor_plugin, m->nsensor, -1);
  std::fill_n(m->geom_plugin, m->ngeom, -1);
  std::fill_n(m->body_plugin, m->nbody, -1);
}

/// Plain colour for everything that will be drawn; nothing of what is not the robot will be.
void recolour(mjModel* m, int root) {
  for (int g = 0; g < m->ngeom; ++g) {
    float* const rgba = m->geom_rgba + 4 * g;
    const int material = m->geom_matid[g];
    const bool seen = (material < 0 ? rgba[3] : m->mat_rgba[4 * material + 3]) > 0.0F;
    const bool own = m->body_rootid[m->geom_bodyid[g]] == root;
    m->geom_matid[g] = -1;
    std::copy(kGhostColour.begin(), kGhostColour.end(), rgba);
    if (!own || !seen) rgba[3] = 0.0F;
  }
  for (int t = 0; t < m->ntendon; ++t) {
    m->tendon_matid[t] = -1;
    std::copy(kGhostColour.begin(), kGhostColour.end(), m->tendon_rgba + 4 * t);
  }
}

}  // namespace

Ghost::Ghost(const mjModel* m, const Robot& robot)
    : robot_(robot), model_(mj_copyModel(nullptr, m)) {
  if (!model_) throw std::bad_alloc();
  remove_plugins(model_.get());
  recolour(model_.get(), robot.root_body);
  data_.reset(mj_makeData(model_.get()));
  if (!data_) throw std::bad_alloc();
  // A tendon is drawn as one piece for each of its wraps, two where it goes round a geom.
  most_geoms_ = static_cast<int>(m->ngeom + 2 * m->nwrap);
}

void Ghost::draw(const PdPlayback& playback, double time, const mjvOption* option,
                 mjvScene* scene) const noexcept {
  const int first = scene->ngeom;
  if (scene->maxgeom - first < most_geoms_) return;
  const mjModel* const m = model_.get();
  mjData* const d = data_.get();
  write_planned_pose(m, playback, robot_, time, d->qpos);
  mj_kinematics(m, d);
  mj_comPos(m, d);
  mj_tendon(m, d);

  mjvOption plain = *option;
  std::fill_n(plain.flags, mjNVISFLAG, mjtByte{0});
  plain.flags[mjVIS_CONVEXHULL] = option->flags[mjVIS_CONVEXHULL];
  plain.flags[mjVIS_TENDON] = option->flags[mjVIS_TENDON];
  plain.label = mjLABEL_NONE;
  plain.frame = mjFRAME_NONE;
  for (mjtByte* const group : {plain.sitegroup, plain.flexgroup, plain.skingroup})
    std::fill_n(group, mjNGROUP, mjtByte{0});  // soft parts are drawn from the scene's own buffers
  mjv_addGeoms(m, d, &plain, nullptr, mjCAT_DYNAMIC, scene);
  for (int g = first; g < scene->ngeom; ++g) make_decoration(scene->geoms[g]);
}

}  // namespace legwright
