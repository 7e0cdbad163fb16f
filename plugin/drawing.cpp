// SPDX-License-Identifier: Apache-2.0
#include "plugin/drawing.hpp"

namespace legwright {

void make_decoration(mjvGeom& geom) noexcept {
  geom.category = mjCAT_DECOR;
  geom.objtype = mjOBJ_UNKNOWN;
  geom.objid = -1;
  geom.segid = -1;
  geom.transparent = geom.rgba[3] < 1.0F;
}

mjvGeom* Pen::add(int type, const mjtNum* size, const mjtNum* position,
                  const Colour& colour) noexcept {
  if (scene_->ngeom >= scene_->maxgeom) return nullptr;
  mjvGeom& geom = scene_->geoms[scene_->ngeom++];
  mjv_initGeom(&geom, type, size, position, nullptr, colour.data());
  make_decoration(geom);
  return &geom;
}

void Pen::connect(int type, const Point& from, const Point& to, double radius,
                  const Colour& colour) noexcept {
  mjvGeom* const geom = add(type, nullptr, nullptr, colour);
  if (geom != nullptr) mjv_connector(geom, type, radius, from.data(), to.data());
}

void Pen::rod(const Point& from, const Point& to, double radius, const Colour& colour) noexcept {
  connect(mjGEOM_CAPSULE, from, to, radius, colour);
}

void Pen::arrow(const Point& from, const Point& to, double radius, const Colour& colour) noexcept {
  connect(mjGEOM_ARROW, from, to, radius, colour);
}

void Pen::ball(const Point& centre, double radius, const Colour& colour) noexcept {
  const mjtNum size[3] = {radius, radius, radius};
  add(mjGEOM_SPHERE, size, centre.data(), colour);
}

void Pen::disc(const Point& centre, double radius, double height, const Colour& colour) noexcept {
  const mjtNum size[3] = {radius, height / 2.0, 0.0};
  add(mjGEOM_CYLINDER, size, centre.data(), colour);
}

}  // namespace legwright
