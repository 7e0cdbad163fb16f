// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "mjcf/shape/simpler_mesh.hpp"
#include "mjcf/text/file_reach.hpp"

namespace legwright {

/// Triangles that a Collada file keeps: enough for pictures of a robot.
inline constexpr int kMostColladaTriangles = 3000;

/// The Collada files (.dae) that a URDF names, each read once (read_collada()) and simplified.
class ColladaMeshes {
 public:
  /// @param folder of the URDF @param reach where its files may lie
  ColladaMeshes(std::filesystem::path folder, FileReach reach);

  /// The mesh of a file; null for other files and for those that cannot be read, hold no triangles
  /// or are flat, of which MuJoCo makes no mesh. @param path from the folder, or absolute
  const DrawnMesh* find(const std::string& path);

 private:
  std::optional<DrawnMesh> read(const std::string& path) const;

  std::filesystem::path folder_;
  FileReach reach_;
  std::map<std::string, std::optional<DrawnMesh>> known_;
};

}  // namespace legwright
