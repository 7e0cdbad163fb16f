// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/foot_touch.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "mjcf/scene/played_robot.hpp"

namespace legwright {
namespace {

using ConstVector3 = Eigen::Map<const Eigen::Vector3d>;
using ConstFrame = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

/// Site at the planned point of a foot that is no single ball; −1 where there is none.
int foot_site(const mjModel& model, int geom) {
  const char* const name = mj_id2name(&model, mjOBJ_GEOM, geom);
  return name ? mj_name2id(&model, mjOBJ_SITE, (kFootSite + std::string(name)).c_str()) : -1;
}

/// Whether a geom is the foot's, or another of those alike in whose middle it is.
bool belongs_to(const mjModel& model, int geom, int foot) {
  if (geom == foot) return true;
  return model.geom_bodyid[geom] == model.geom_bodyid[foot] &&
         model.geom_type[geom] == model.geom_type[foot] &&
         model.geom_dataid[geom] == model.geom_dataid[foot] &&
         std::equal(model.geom_size + 3 * geom, model.geom_size + 3 * geom + 3,
                    model.geom_size + 3 * foot) &&
         foot_site(model, foot) >= 0;
}

}  // namespace

double foot_radius(const mjModel& model, int geom) {
  if (model.geom_type[geom] == mjGEOM_SPHERE) return model.geom_size[3 * geom];
  const int site = foot_site(model, geom);
  return site >= 0 && model.site_type[site] == mjGEOM_SPHERE ? model.site_size[3 * site] : 0.0;
}

Eigen::Vector3d foot_position(const mjModel& model, const mjData& data, int geom) {
  const int site = foot_site(model, geom);
  return ConstVector3(site >= 0 ? data.site_xpos + 3 * site : data.geom_xpos + 3 * geom);
}

FootMotion foot_motion(const mjModel& model, const mjData& data, int geom) {
  mjtNum velocity[6];
  mj_objectVelocity(&model, &data, mjOBJ_GEOM, geom, velocity, 0);
  const Eigen::Vector3d bottom =
      foot_position(model, data, geom) - foot_radius(model, geom) * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d arm = bottom - ConstVector3(data.geom_xpos + 3 * geom);
  return {ConstVector3(velocity + 3) + ConstVector3(velocity).cross(arm),
          {velocity[0], velocity[1]},
          bottom};
}

double read_foot_touches(const Scene& scene, const mjData& data, std::vector<FootTouch>& touches) {
  const mjModel& model = *scene.model;
  touches.assign(scene.foot_geom.size(), FootTouch{});
  double depth = 0.0;
  for (int c = 0; c < data.ncon; ++c) {
    const mjContact& contact = data.contact[c];
    if (contact.geom[0] < 0 || contact.geom[1] < 0) continue;
    const bool first_is_world = model.geom_bodyid[contact.geom[0]] == 0;
    if (!first_is_world && model.geom_bodyid[contact.geom[1]] != 0) continue;
    depth = std::max(depth, -contact.dist);
    const int geom = contact.geom[first_is_world ? 1 : 0];
    const auto found = std::find_if(scene.foot_geom.begin(), scene.foot_geom.end(),
                                    [&](int foot) { return belongs_to(model, geom, foot); });
    if (found == scene.foot_geom.end()) continue;
    mjtNum force[6], velocity[6];
    mj_contactForce(&model, &data, c, force);
    mj_objectVelocity(&model, &data, mjOBJ_GEOM, geom, velocity, 0);
    const Eigen::Vector3d arm = ConstVector3(contact.pos) - ConstVector3(data.geom_xpos + 3 * geom);
    const Eigen::Vector3d speed = ConstVector3(velocity + 3) + ConstVector3(velocity).cross(arm);
    const ConstVector3 normal(contact.frame);
    FootTouch& touch = touches[static_cast<std::size_t>(found - scene.foot_geom.begin())];
    // The contact's normal points from its first geom to its second, and so does the force on the
    // second.
    const double sign = first_is_world ? 1.0 : -1.0;
    touch.force += sign * (ConstFrame(contact.frame).transpose() * ConstVector3(force));
    touch.normal += force[0];
    touch.slip_speed = std::max(touch.slip_speed, (speed - normal * normal.dot(speed)).norm());
  }
  return depth;
}

}  // namespace legwright
