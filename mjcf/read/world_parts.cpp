// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/world_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mjcf/read/feet.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/listed.hpp"

namespace legwright {
namespace {

struct KindOfGeom {
  const char *one, *several;
};

KindOfGeom kind_of(int type) {
  switch (type) {
    case mjGEOM_PLANE:
      return {"plane", "planes"};
    case mjGEOM_HFIELD:
      return {"height field", "height fields"};
    case mjGEOM_SPHERE:
      return {"ball", "balls"};
    case mjGEOM_CAPSULE:
      return {"capsule", "capsules"};
    case mjGEOM_ELLIPSOID:
      return {"ellipsoid", "ellipsoids"};
    case mjGEOM_CYLINDER:
      return {"cylinder", "cylinders"};
    case mjGEOM_BOX:
      return {"box", "boxes"};
    case mjGEOM_MESH:
      return {"mesh", "meshes"};
    default:
      return {"geom", "geoms"};
  }
}

bool is_wide(const mjModel& model, int geom) {
  return model.geom_type[geom] == mjGEOM_PLANE || model.geom_type[geom] == mjGEOM_HFIELD;
}

/// Whether a body or one below it has a joint besides a free one.
bool has_hinges(const mjModel& model, int root) {
  for (int j = 0; j < model.njnt; ++j)
    if (model.body_rootid[model.jnt_bodyid[j]] == root && model.jnt_type[j] != mjJNT_FREE)
      return true;
  return false;
}

bool has_geoms(const mjModel& model, int root) {
  for (int g = 0; g < model.ngeom; ++g)
    if (model.body_rootid[model.geom_bodyid[g]] == root) return true;
  return false;
}

bool is_free(const mjModel& model, int root) {
  return model.body_jntnum[root] == 1 && model.jnt_type[model.body_jntadr[root]] == mjJNT_FREE;
}

}  // namespace

int trunk_of(const mjModel& model) {
  int first = -1;
  for (int b = 1; b < static_cast<int>(model.nbody); ++b) {
    if (model.body_jntnum[b] == 0 || model.jnt_type[model.body_jntadr[b]] != mjJNT_FREE) continue;
    if (has_hinges(model, b)) return b;
    if (first < 0) first = b;
  }
  return first;
}

bool moves_beside(const mjModel& model, int root) {
  if (root == trunk_of(model)) return false;
  return is_free(model, root) ? !has_hinges(model, root)
                              : has_hinges(model, root) && !has_geoms(model, root);
}

std::vector<int> bodies_beside(const mjModel& model) {
  std::vector<int> out;
  for (int b = 1; b < static_cast<int>(model.nbody); ++b)
    if (model.body_parentid[b] == 0 && moves_beside(model, b)) out.push_back(b);
  return out;
}

bool is_of_surroundings(const mjModel& model, int geom) {
  return model.body_weldid[model.geom_bodyid[geom]] == 0 &&
         (collides(model, geom) || is_wide(model, geom));
}

std::vector<std::string> surroundings_of(const mjModel& model) {
  std::vector<std::string> out;
  std::vector<std::pair<int, int>> unnamed;  // type and how many
  for (int g = 0; g < model.ngeom; ++g) {
    if (!is_of_surroundings(model, g)) continue;
    const int type = model.geom_type[g];
    if (const std::string name = name_of(model, mjOBJ_GEOM, g); !name.empty()) {
      out.push_back(fmt::format("{} '{}'", kind_of(type).one, name));
      continue;
    }
    const auto known = std::find_if(unnamed.begin(), unnamed.end(),
                                    [&](const auto& each) { return each.first == type; });
    if (known != unnamed.end())
      ++known->second;
    else
      unnamed.emplace_back(type, 1);
  }
  for (const auto& [type, count] : unnamed)
    out.push_back(count == 1 ? fmt::format("a {}", kind_of(type).one)
                             : fmt::format("{} {}", count, kind_of(type).several));
  for (const int body : bodies_beside(model))
    out.push_back(
        fmt::format("body '{}', which moves by itself", name_of(model, mjOBJ_BODY, body)));
  return out;
}

std::string describe_surroundings(const std::vector<std::string>& surroundings) {
  if (surroundings.empty()) return "";
  constexpr std::size_t kNamed = 6;
  return fmt::format(
      "surroundings in its file: {}; gaits are planned and judged on a level floor in their place",
      listed(surroundings, kNamed));
}

bool has_ground(const mjModel& model) {
  for (int g = 0; g < model.ngeom; ++g)
    if (is_of_surroundings(model, g) && collides(model, g) &&
        (is_wide(model, g) || name_of(model, mjOBJ_GEOM, g) == "floor"))
      return true;
  return false;
}

}  // namespace legwright
