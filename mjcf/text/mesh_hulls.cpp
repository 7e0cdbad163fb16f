// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/mesh_hulls.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mjcf/text/file_state.hpp"
#include "mjcf/text/hull_graph.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "mjcf/text/mujoco_pointers.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kFlatBox = 1e-4;  // of a box's longest side: it has no volume
// Of the box with a mesh's own moments: sizes that are tried until it lies within the hull.
constexpr double kLargest = 0.5, kSmallest = 1.0 / 32.0;

/// Closed triangles within a hull, and the hull's corners, in the axes of the file.
struct HullMesh {
  std::vector<float> vertices;
  std::vector<int> faces;
};

/// Whether a box around the origin lies within a hull around it.
bool is_within(const Vector3d& half, const std::vector<int>& faces, const auto& vertex) {
  for (std::size_t f = 0; f + 2 < faces.size(); f += 3) {
    const Vector3d a = vertex(faces[f]);
    const Vector3d normal = (vertex(faces[f + 1]) - a).cross(vertex(faces[f + 2]) - a);
    if (normal.cwiseAbs().dot(half) >= std::abs(normal.dot(a))) return false;
  }
  return true;
}

/// A mesh of the corners of a hull, and of a box within it that has the second moments of the whole
/// up to a factor: both follow a linear map of all vertices alike. Nothing where there is no room.
std::optional<HullMesh> hull_mesh(const mjModel& model, int mesh, int body) {
  if (mesh < 0 || body < 0 || !has_hull(model, mesh)) return std::nullopt;
  const double mass = model.body_mass[body];
  const Vector3d inertia = vector_at(model.body_inertia, body);
  const Vector3d squares =
      (1.5 / mass) * (Vector3d::Constant(inertia.sum()) - 2.0 * inertia);  // of half sides
  if (!(squares.minCoeff() > kFlatBox * kFlatBox * squares.maxCoeff())) return std::nullopt;
  const HullGraph graph(model, mesh);
  const auto vertex = [&](int id) { return mesh_vertex(model, mesh, id); };
  double share = kLargest;
  while (!is_within(share * squares.cwiseSqrt(), graph.faces, vertex))
    if ((share /= 2) < kSmallest) return std::nullopt;
  const Vector3d half = share * squares.cwiseSqrt();
  const Vector3d place = vector_at(model.mesh_pos, mesh);
  const Matrix3d axes = rotation_at(model.mesh_quat, mesh);
  HullMesh out;
  const auto add = [&](const Vector3d& v) {
    const Vector3d in_file = place + axes * v;
    for (const double x : in_file) out.vertices.push_back(static_cast<float>(x));
  };
  for (int k = 0; k < 8; ++k)
    add(half.cwiseProduct(Vector3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
  for (const int corner : graph.corners) add(vertex(corner));
  // Seen from outside the triangles run counter-clockwise.
  out.faces = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
               2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return out;
}

struct MeshFile {
  std::string path, content_type;
  mjtMeshInertia inertia;
};

/// Turns off MuJoCo's own memory of files, which knows no change within a second and holds all
/// triangles. One at a time.
class NoAssetCache {
 public:
  NoAssetCache() { mj_setCacheCapacity(mj_getCache(), 0); }
  ~NoAssetCache() { mj_setCacheCapacity(mj_getCache(), capacity_); }
  NoAssetCache(const NoAssetCache&) = delete;
  NoAssetCache& operator=(const NoAssetCache&) = delete;

 private:
  std::size_t capacity_ = mj_getCacheCapacity(mj_getCache());
};

/// The hull of a mesh file; nothing where MuJoCo refuses the file or finds none.
std::optional<HullMesh> compile_hull(const MeshFile& file) {
  constexpr const char* kName = "mesh";
  const SpecPointer spec(mj_makeSpec());
  spec->compiler.balanceinertia = 1;
  mjsMesh* const mesh = mjs_addMesh(spec.get(), nullptr);
  mjs_setName(mesh->element, kName);
  mjs_setString(mesh->file, file.path.c_str());
  mjs_setString(mesh->content_type, file.content_type.c_str());
  mesh->inertia = file.inertia;
  mjsBody* const body = mjs_addBody(mjs_findBody(spec.get(), "world"), nullptr);
  mjs_setName(body->element, kName);
  mjsGeom* const geom = mjs_addGeom(body, nullptr);
  geom->type = mjGEOM_MESH;
  mjs_setString(geom->meshname, kName);
  const NoAssetCache none;
  const ModelPointer model(mj_compile(spec.get(), nullptr));
  if (!model) return std::nullopt;
  return hull_mesh(*model, mj_name2id(model.get(), mjOBJ_MESH, kName),
                   mj_name2id(model.get(), mjOBJ_BODY, kName));
}

/// Whether two files have the same bytes.
bool same_bytes(const std::string& one, const std::string& other) {
  constexpr std::size_t kBlock = 1 << 16;
  std::ifstream a(one, std::ios::binary), b(other, std::ios::binary);
  std::vector<char> of_a(kBlock), of_b(kBlock);
  while (a && b) {
    a.read(of_a.data(), kBlock);
    b.read(of_b.data(), kBlock);
    if (a.gcount() != b.gcount() ||
        !std::equal(of_a.begin(), of_a.begin() + a.gcount(), of_b.begin()))
      return false;
  }
  return a.eof() && b.eof();
}

/// Hulls of the files that were asked for last; nothing for those that have none.
class KnownHulls {
 public:
  std::optional<HullMesh> of(const MeshFile& file) {
    const std::optional<FileState> state = state_of(file.path);
    if (!state) return std::nullopt;
    const std::lock_guard lock(mutex_);
    for (const Known& each : known_)
      if (each.state == *state && each.inertia == file.inertia) return each.hull;
    Known found{file.path, *state, file.inertia, {}};
    if (const Known* const copy = copy_of(found))
      found.hull = copy->hull;
    else
      found.hull = compile_hull(file);
    known_.push_back(found);
    if (known_.size() > kKept) known_.pop_front();
    return found.hull;
  }

 private:
  static constexpr std::size_t kKept = 256;
  struct Known {
    std::string path;
    FileState state;
    mjtMeshInertia inertia;
    std::optional<HullMesh> hull;
  };

  /// A known file, as it was then, with the same bytes: runs have copies of what they are of.
  const Known* copy_of(const Known& file) const {
    for (const Known& each : known_)
      if (each.state.size == file.state.size && each.inertia == file.inertia &&
          state_of(each.path) == each.state && same_bytes(each.path, file.path))
        return &each;
    return nullptr;
  }

  std::mutex mutex_;
  std::deque<Known> known_;  // the oldest first
};

/// Where MuJoCo looks for the file of a mesh.
std::string path_of(const mjSpec& spec, const mjsMesh& mesh) {
  std::string file = mjs_getString(mesh.file);
  if (spec.strippath) file.erase(0, file.find_last_of("/\\") + 1);
  const std::filesystem::path folder = mjs_getString(spec.compiler.meshdir);
  return (std::filesystem::path(mjs_getString(spec.modelfiledir)) / folder / file).string();
}

bool is_weightless(const mjsGeom& geom) {
  return geom.mass == 0.0 || (std::isnan(geom.mass) && geom.density == 0.0);
}

/// Whether a geom needs no more of its mesh than hull and frame.
bool needs_hull_alone(mjSpec& spec, const mjsGeom& geom) {
  if (geom.type != mjGEOM_MESH || geom.plugin.active || geom.fluid_ellipsoid > 0) return false;
  if (is_weightless(geom)) return true;
  const mjsBody* const body = mjs_getParent(geom.element);
  if (body == nullptr) return false;
  return body == mjs_findBody(&spec, "world") ||
         (body->explicitinertial && spec.compiler.inertiafromgeom != mjINERTIAFROMGEOM_TRUE);
}

std::vector<mjsMesh*> replaceable_meshes(mjSpec& spec) {
  std::set<std::string> needed_whole;
  for (mjsElement* each = mjs_firstElement(&spec, mjOBJ_GEOM); each != nullptr;
       each = mjs_nextElement(&spec, each)) {
    const mjsGeom& geom = *mjs_asGeom(each);
    if (!needs_hull_alone(spec, geom)) needed_whole.insert(mjs_getString(geom.meshname));
  }
  std::vector<mjsMesh*> out;
  for (mjsElement* each = mjs_firstElement(&spec, mjOBJ_MESH); each != nullptr;
       each = mjs_nextElement(&spec, each)) {
    mjsMesh& mesh = *mjs_asMesh(each);
    const std::string file = mjs_getString(mesh.file);
    if (file.empty() || mesh.needsdf || mesh.plugin.active || mesh.maxhullvert != -1) continue;
    std::string name = mjs_getString(mjs_getName(each));
    if (name.empty()) name = std::filesystem::path(file).stem().string();
    if (needed_whole.count(name) == 0) out.push_back(&mesh);
  }
  return out;
}

void replace(mjsMesh& mesh, const HullMesh& hull) {
  const std::string stem = std::filesystem::path(mjs_getString(mesh.file)).stem().string();
  if (*mjs_getString(mjs_getName(mesh.element)) == '\0') mjs_setName(mesh.element, stem.c_str());
  mjs_setString(mesh.file, "");
  mjs_setString(mesh.content_type, "");
  mjs_setFloat(mesh.uservert, hull.vertices.data(), static_cast<int>(hull.vertices.size()));
  mjs_setInt(mesh.userface, hull.faces.data(), static_cast<int>(hull.faces.size()));
  mesh.inertia = mjMESH_INERTIA_LEGACY;
}

}  // namespace

void put_hulls_for_meshes(mjSpec& spec) {
  static KnownHulls known;
  for (mjsMesh* const mesh : replaceable_meshes(spec))
    if (const auto hull =
            known.of({path_of(spec, *mesh), mjs_getString(mesh->content_type), mesh->inertia}))
      replace(*mesh, *hull);
}

}  // namespace legwright
