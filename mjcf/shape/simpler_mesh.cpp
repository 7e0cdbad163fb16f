// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/simpler_mesh.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace legwright {
namespace {

constexpr std::size_t kStride = 3 * sizeof(float);
constexpr double kTooMany = 1.3;  // of what is asked: edges and seams hold a mesh up

/// Leaves out vertices that no face has.
void drop_unused(DrawnMesh& mesh) {
  std::vector<float> vertices(mesh.vertices.size());
  const std::size_t count =
      meshopt_optimizeVertexFetch(vertices.data(), mesh.faces.data(), mesh.faces.size(),
                                  mesh.vertices.data(), mesh.vertices.size() / 3, kStride);
  vertices.resize(3 * count);
  mesh.vertices = std::move(vertices);
}

}  // namespace

DrawnMesh simpler_mesh(DrawnMesh mesh, double share) {
  if (share >= 1.0 || mesh.faces.empty()) return mesh;
  const auto triangles = static_cast<double>(mesh.triangles());
  const std::size_t target = 3 * static_cast<std::size_t>(std::max(1.0, share * triangles));
  const float* const places = mesh.vertices.data();
  const std::size_t vertices = mesh.vertices.size() / 3;
  constexpr float kAny = std::numeric_limits<float>::max();  // error
  std::vector<std::uint32_t> faces(mesh.faces.size());
  std::size_t kept = meshopt_simplify(faces.data(), mesh.faces.data(), mesh.faces.size(), places,
                                      vertices, kStride, target, kAny, 0, nullptr);
  if (static_cast<double>(kept) > kTooMany * static_cast<double>(target))
    kept = meshopt_simplifySloppy(faces.data(), mesh.faces.data(), mesh.faces.size(), places,
                                  vertices, kStride, target, kAny, nullptr);
  faces.resize(kept);
  if (!faces.empty()) mesh.faces = std::move(faces);
  drop_unused(mesh);
  return mesh;
}

}  // namespace legwright
