// SPDX-License-Identifier: Apache-2.0
#include "tools/drawables/viewed_scene.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "mjcf/scene/seen_shapes.hpp"
#include "tools/drawables/drawn_design.hpp"
#include "tools/drawables/motion_frames.hpp"
#include "tools/simulate/mujoco_host.hpp"

namespace legwright {
namespace {

bool is_seen(const Json& geom) {
  return geom.at("group").get<int>() <= kHighestSeenGroup &&
         geom.at("rgba").at(3).get<double>() > 0.0 && geom.at("type") != "plane";
}

/// Triangles of the meshes that are seen, each mesh of a model once.
double seen_triangles(const mjModel& model) {
  std::set<int> meshes;
  const std::vector<int> groups = drawn_groups(model);
  for (int geom = 0; geom < model.ngeom; ++geom)
    if (model.geom_type[geom] == mjGEOM_MESH &&
        groups[static_cast<std::size_t>(geom)] <= kHighestSeenGroup)
      meshes.insert(model.geom_dataid[geom]);
  double out = 0.0;
  for (const int mesh : meshes) out += model.mesh_facenum[mesh];
  return out;
}

/// The bodies and what is seen of them, with the meshes that these name.
Json viewed_design(const mjModel& model, MeshStore& meshes) {
  const Json drawn = drawables_json(model, meshes);
  Json out{{"bodies", drawn.at("bodies")}, {"geoms", Json::array()}, {"meshes", Json::object()}};
  for (const Json& geom : drawn.at("geoms")) {
    if (!is_seen(geom)) continue;
    out["geoms"].push_back(geom);
    if (geom.at("mesh").is_null()) continue;
    const std::string id = geom.at("mesh").get<std::string>();
    out["meshes"][id] = Json::parse(*meshes.find(id));
  }
  return out;
}

Json viewed_motion(const Scene& scene) {
  const mjModel& model = *scene.model;
  Json out = motion_frames_json(model, scene.trajectory);
  for (std::size_t foot = 0; foot < scene.foot_geom.size(); ++foot) {
    const int geom = scene.foot_geom[foot];
    out["feet"][foot]["body"] = model.geom_bodyid[geom];
    out["feet"][foot]["radius"] = model.geom_size[3L * geom];
  }
  out["weight"] = robot_weight(model, scene.joints);
  out["faults"] = Json::array();
  out["predicted"] = false;
  return out;
}

}  // namespace

Json viewed_scenes_json(const std::vector<NamedScene>& scenes, int most_triangles) {
  double triangles = 0.0;
  for (const NamedScene& each : scenes) triangles += seen_triangles(*each.scene.model);
  MeshStore meshes(triangles > most_triangles ? most_triangles / triangles : 1.0);
  Json out = Json::array();
  for (const NamedScene& each : scenes)
    out.push_back({{"name", each.name},
                   {"design", viewed_design(*each.scene.model, meshes)},
                   {"motion", viewed_motion(each.scene)}});
  return out;
}

}  // namespace legwright
