// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace legwright {

/// Triangles as they are drawn: three coordinates for each vertex [m], three vertices for each
/// face.
struct DrawnMesh {
  std::vector<float> vertices;
  std::vector<std::uint32_t> faces;

  std::size_t triangles() const { return faces.size() / 3; }
};

/// The mesh with at most this share of its triangles, about: those go first whose loss is seen
/// least. Vertices without a face are gone. A share of 1 gives the mesh back.
DrawnMesh simpler_mesh(DrawnMesh mesh, double share);

}  // namespace legwright
