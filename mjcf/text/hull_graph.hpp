// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace legwright {

/// Whether the engine has the convex hull of a mesh: it makes those of meshes that collide.
inline bool has_hull(const mjModel& model, int mesh) { return model.mesh_graphadr[mesh] >= 0; }

/// A vertex of a mesh in the engine's axes of it [m].
inline Eigen::Vector3d mesh_vertex(const mjModel& model, int mesh, int id) {
  return Eigen::Map<const Eigen::Vector3f>(model.mesh_vert +
                                           std::ptrdiff_t{3} * (model.mesh_vertadr[mesh] + id))
      .cast<double>();
}

/// The convex hull of a mesh that has one, by ids of mesh_vertex(). As the engine keeps it: numbers
/// of corners and faces, then for each corner its first edge and its vertex, the edges, the
/// vertices of the faces.
struct HullGraph {
  HullGraph(const mjModel& model, int mesh) {
    const int* const graph = model.mesh_graph + model.mesh_graphadr[mesh];
    const std::ptrdiff_t corner_count = graph[0], face_count = graph[1];
    corners.assign(graph + 2 + corner_count, graph + 2 + 2 * corner_count);
    const int* const of_faces = graph + 2 + 3 * corner_count + 3 * face_count;
    faces.assign(of_faces, of_faces + 3 * face_count);
  }
  std::vector<int> corners, faces;  // three entries a face
};

}  // namespace legwright
