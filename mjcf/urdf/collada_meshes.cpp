// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/collada_meshes.hpp"

#include <Eigen/Eigenvalues>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/safe_path.hpp"
#include "mjcf/urdf/collada.hpp"
#include "mjcf/urdf/urdf_meshes.hpp"

namespace legwright {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;
constexpr double kFlat = 1e-5;  // thickness over width

bool is_flat(const DrawnMesh& mesh) {
  const auto count = static_cast<Eigen::Index>(mesh.vertices.size() / 3);
  if (count < 4) return true;
  const Eigen::Matrix3Xd points =
      Eigen::Map<const Eigen::Matrix3Xf>(mesh.vertices.data(), 3, count).cast<double>();
  const Eigen::Matrix3Xd off = points.colwise() - points.rowwise().mean();
  const Eigen::Vector3d squares =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(off * off.transpose()).eigenvalues();
  return !(squares[0] > kFlat * kFlat * squares[2]);
}

}  // namespace

ColladaMeshes::ColladaMeshes(std::filesystem::path folder, FileReach reach)
    : folder_(std::move(folder)), reach_(std::move(reach)) {}

const DrawnMesh* ColladaMeshes::find(const std::string& path) {
  if (!is_collada(path)) return nullptr;
  auto known = known_.find(path);
  if (known == known_.end()) known = known_.emplace(path, read(path)).first;
  return known->second ? &*known->second : nullptr;
}

std::optional<DrawnMesh> ColladaMeshes::read(const std::string& path) const {
  const FoundFile found = find_file(folder_, path, kMostBytes, reach_);
  if (!found.fault.empty()) return std::nullopt;
  try {
    DrawnMesh mesh = read_collada(read_regular_file(found.source, kMostBytes), found.source);
    const auto triangles = static_cast<double>(mesh.triangles());
    mesh = simpler_mesh(std::move(mesh), kMostColladaTriangles / triangles);
    if (is_flat(mesh)) return std::nullopt;
    return mesh;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace legwright
