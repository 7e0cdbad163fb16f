// SPDX-License-Identifier: Apache-2.0
#include "plugin/model_feet.hpp"

#include <fmt/format.h>

#include "plugin/number_text.hpp"
#include "plugin/playback_config.hpp"

namespace legwright {
ModelFoot find_foot(const mjModel* m, const std::string& name) {
  ModelFoot foot;
  if (const int geom = mj_name2id(m, mjOBJ_GEOM, name.c_str()); geom >= 0) {
    foot.body = m->geom_bodyid[geom];
    foot.geoms = {geom};  // whatever else is called so: names are per kind in MJCF
    return foot;
  }
  const int site = mj_name2id(m, mjOBJ_SITE, name.c_str());
  const int site_body = site < 0 ? -1 : m->site_bodyid[site],
            body = mj_name2id(m, mjOBJ_BODY, name.c_str());
  if (site_body >= 0 && body >= 0 && site_body != body) {
    throw ConfigError(fmt::format(
        "foot {}: the site and the body of this name are on different bodies; rename one",
        quoted(name)));
  }
  foot.body = site_body >= 0 ? site_body : body;
  if (foot.body < 0) {
    throw ConfigError(
        fmt::format("foot {} of the trajectory: the model has no geom, site or body of this name; "
                    "name the geom "
                    "with which it touches the ground so",
                    quoted(name)));
  }
  const int end = m->body_geomadr[foot.body] + m->body_geomnum[foot.body];
  for (int g = m->body_geomadr[foot.body]; g < end && g >= 0; ++g) {
    if (m->geom_contype[g] != 0 || m->geom_conaffinity[g] != 0) foot.geoms.push_back(g);
  }
  if (foot.geoms.empty()) {
    throw ConfigError(
        fmt::format("foot {}: the body of the {} of this name has no geom that collides",
                    quoted(name), site_body >= 0 ? "site" : "body"));
  }
  return foot;
}

std::vector<ModelFoot> find_feet(const mjModel* m, const std::vector<std::string>& names) {
  std::vector<ModelFoot> feet;
  std::vector<int> owner(static_cast<std::size_t>(m->ngeom), -1);
  for (std::size_t i = 0; i < names.size(); ++i) {
    feet.push_back(find_foot(m, names[i]));
    for (const int geom : feet.back().geoms) {
      int& other = owner[static_cast<std::size_t>(geom)];
      if (other >= 0) {
        throw ConfigError(
            fmt::format("feet {} and {} have the same geom; name the geom of each after it",
                        quoted(names[static_cast<std::size_t>(other)]), quoted(names[i])));
      }
      other = static_cast<int>(i);
    }
  }
  return feet;
}

std::vector<int> feet_by_geom(const mjModel* m, const std::vector<ModelFoot>& feet) {
  std::vector<int> foot_of_geom(static_cast<std::size_t>(m->ngeom), -1);
  for (std::size_t i = 0; i < feet.size(); ++i)
    for (const int geom : feet[i].geoms)
      foot_of_geom[static_cast<std::size_t>(geom)] = static_cast<int>(i);
  return foot_of_geom;
}

double foot_contact_force(const mjModel* m, const mjData* d, int contact,
                          const std::vector<int>& foot_of_geom, int& foot) noexcept {
  const mjContact& c = d->contact[contact];
  if (c.efc_address < 0) return 0.0;  // excluded, or within a gap
  for (int side = 0; side < 2; ++side) {
    const int geom = c.geom[side], other = c.geom[1 - side];
    if (geom < 0 || foot_of_geom[static_cast<std::size_t>(geom)] < 0) continue;
    const int robot = m->body_rootid[m->geom_bodyid[geom]];
    if (other >= 0 && m->body_rootid[m->geom_bodyid[other]] == robot) continue;
    foot = foot_of_geom[static_cast<std::size_t>(geom)];
    mjtNum force[6];
    mj_contactForce(m, d, contact, force);
    return force[0];
  }
  return 0.0;
}

}  // namespace legwright
