// SPDX-License-Identifier: Apache-2.0
#include "tools/drawables/drawn_design.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "mjcf/scene/played_robot.hpp"
#include "mjcf/scene/seen_shapes.hpp"
#include "mjcf/shape/simpler_mesh.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tools/files/base64.hpp"

namespace legwright {
namespace {

std::uint64_t mixed(std::uint64_t hash, const void* bytes, std::size_t count) {  // FNV-1a
  for (std::size_t i = 0; i < count; ++i)
    hash = (hash ^ static_cast<const unsigned char*>(bytes)[i]) * 0x100000001B3ULL;
  return hash;
}

const char* type_of(int type) {
  switch (type) {
    case mjGEOM_PLANE:
      return "plane";
    case mjGEOM_SPHERE:
      return "sphere";
    case mjGEOM_CAPSULE:
      return "capsule";
    case mjGEOM_ELLIPSOID:
      return "ellipsoid";
    case mjGEOM_CYLINDER:
      return "cylinder";
    case mjGEOM_BOX:
      return "box";
    case mjGEOM_MESH:
      return "mesh";
    default:
      return nullptr;  // height fields and the like
  }
}

template <class Number>
Json list_of(const Number* numbers, int count) {
  Json out = Json::array();
  for (int k = 0; k < count; ++k) out.push_back(numbers[k]);
  return out;
}

/// As MuJoCo chooses between a geom's own colour and its material's.
Json colour_of(const mjModel& model, int geom) {
  constexpr std::array<float, 4> kNone{0.5F, 0.5F, 0.5F, 1.0F};
  const float* own = model.geom_rgba + 4L * geom;
  const int material = model.geom_matid[geom];
  const bool given = !std::equal(kNone.begin(), kNone.end(), own);
  return list_of(material < 0 || given ? own : model.mat_rgba + 4L * material, 4);
}

}  // namespace

ModelPointer drawn_model(const RobotModel& robot, const Eigen::VectorXd& s) {
  return compile_mjcf(played_robot(robot, rewrite_body(robot, s)), robot.file,
                      MeshDetail::triangles);
}

std::string MeshStore::add(const mjModel& model, int mesh) {
  const int vertices = model.mesh_vertnum[mesh], faces = model.mesh_facenum[mesh];
  const float* vertex = model.mesh_vert + 3L * model.mesh_vertadr[mesh];
  const int* face = model.mesh_face + 3L * model.mesh_faceadr[mesh];
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  hash = mixed(hash, vertex, sizeof(float) * 3 * static_cast<std::size_t>(vertices));
  hash = mixed(hash, face, sizeof(int) * 3 * static_cast<std::size_t>(faces));
  std::string id = fmt::format("{:016x}", hash);
  const std::lock_guard lock(mutex_);
  auto& kept = meshes_[id];
  if (kept) return id;
  const DrawnMesh drawn =
      simpler_mesh({{vertex, vertex + 3 * static_cast<std::ptrdiff_t>(vertices)},
                    {face, face + 3 * static_cast<std::ptrdiff_t>(faces)}},
                   share_);
  kept = std::make_shared<const std::string>(
      Json{{"vertices", base64_of(drawn.vertices)}, {"faces", base64_of(drawn.faces)}}.dump());
  return id;
}

std::shared_ptr<const std::string> MeshStore::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = meshes_.find(id);
  return found == meshes_.end() ? nullptr : found->second;
}

Json drawables_json(const mjModel& model, MeshStore& meshes) {
  Json bodies = Json::array(), geoms = Json::array();
  const std::vector<int> groups = drawn_groups(model);
  for (int body = 0; body < model.nbody; ++body)
    bodies.push_back(
        {{"name", name_of(model, mjOBJ_BODY, body)}, {"parent", model.body_parentid[body]}});
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const char* type = type_of(model.geom_type[geom]);
    if (!type) continue;
    const bool mesh = model.geom_type[geom] == mjGEOM_MESH;
    geoms.push_back({{"body", model.geom_bodyid[geom]},
                     {"name", name_of(model, mjOBJ_GEOM, geom)},
                     {"type", type},
                     {"size", list_of(model.geom_size + 3L * geom, 3)},
                     {"pos", list_of(model.geom_pos + 3L * geom, 3)},
                     {"quat", list_of(model.geom_quat + 4L * geom, 4)},
                     {"rgba", colour_of(model, geom)},
                     {"mesh", mesh ? Json(meshes.add(model, model.geom_dataid[geom])) : nullptr},
                     {"group", groups[static_cast<std::size_t>(geom)]}});
  }
  return {{"bodies", bodies}, {"geoms", geoms}};
}

Json posed_drawables_json(const mjModel& model, const mjData& data, MeshStore& meshes) {
  std::vector<float> poses;
  for (int body = 0; body < static_cast<int>(model.nbody); ++body) {
    for (int k = 0; k < 3; ++k) poses.push_back(static_cast<float>(data.xpos[3 * body + k]));
    for (int k = 0; k < 4; ++k) poses.push_back(static_cast<float>(data.xquat[4 * body + k]));
  }
  Json out = drawables_json(model, meshes);
  out["poses"] = base64_of(poses);
  return out;
}

}  // namespace legwright
