// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

#include "mjcf/shape/simpler_mesh.hpp"
#include "mjcf/text/file_reach.hpp"

namespace legwright {

/// Triangles, about, that each of the first files keeps, enough for pictures of a robot, and that
/// each of many more keeps, so that an MJCF holds them all.
inline constexpr int kColladaTriangles = 3000, kFewColladaTriangles = 100;
inline constexpr std::size_t kManyColladaFiles = 32;

/// A Collada file as a mesh, or why it is none.
struct ColladaMesh {
  DrawnMesh mesh;
  std::string fault;     // as a text of find_file() or read_collada(); empty: `mesh` holds it
  bool is_flat = false;  // the fault is that the file has no volume, of which MuJoCo makes no mesh
};

/// The Collada files (.dae) that a URDF names, each read once (read_collada()) and simplified.
class ColladaMeshes {
 public:
  /// @param folder of the URDF @param reach where its files may lie
  ColladaMeshes(std::filesystem::path folder, FileReach reach);

  /// Null for files that are not called so. @param path from the folder, or absolute
  const ColladaMesh* find(const std::string& path);

 private:
  ColladaMesh read(const std::string& path, int triangles) const;

  std::filesystem::path folder_;
  FileReach reach_;
  std::map<std::string, ColladaMesh> known_;
};

}  // namespace legwright
