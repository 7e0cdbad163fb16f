// SPDX-License-Identifier: Apache-2.0
#include "mjcf/urdf/collada_meshes.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/safe_path.hpp"
#include "mjcf/urdf/collada.hpp"
#include "mjcf/urdf/urdf_meshes.hpp"

namespace legwright {
namespace {

constexpr std::uintmax_t kMostBytesOfMesh = std::uintmax_t{64} << 20;
constexpr double kFlatMesh = 1e-5;  // thickness over width

bool is_flat(const DrawnMesh& mesh) {
  const auto count = static_cast<Eigen::Index>(mesh.vertices.size() / 3);
  if (count < 4) return true;
  const Eigen::Matrix3Xd points =
      Eigen::Map<const Eigen::Matrix3Xf>(mesh.vertices.data(), 3, count).cast<double>();
  const Eigen::Matrix3Xd off = points.colwise() - points.rowwise().mean();
  const Eigen::Vector3d squares =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(off * off.transpose()).eigenvalues();
  return !(squares[0] > kFlatMesh * kFlatMesh * squares[2]);
}

}  // namespace

ColladaMeshes::ColladaMeshes(std::filesystem::path folder, FileReach reach)
    : folder_(std::move(folder)), reach_(std::move(reach)) {}

const ColladaMesh* ColladaMeshes::find(const std::string& path) {
  if (!is_collada(path)) return nullptr;
  auto known = known_.find(path);
  if (known == known_.end()) {
    const bool many = known_.size() >= kManyColladaFiles;
    known = known_.emplace(path, read(path, many ? kFewColladaTriangles : kColladaTriangles)).first;
  }
  return &known->second;
}

ColladaMesh ColladaMeshes::read(const std::string& path, int triangles) const {
  ColladaMesh out;
  const FoundFile found = find_file(folder_, path, kMostBytesOfMesh, reach_);
  out.fault = found.fault;
  if (!out.fault.empty()) return out;
  try {
    out.mesh = read_collada(read_regular_file(found.source, kMostBytesOfMesh), found.source);
  } catch (const InputError& error) {
    out.fault = fmt::format("is no Collada that can be read: {}", error.what());
    return out;
  }
  const auto all = static_cast<double>(out.mesh.triangles());
  out.mesh = simpler_mesh(std::move(out.mesh), triangles / all);
  out.is_flat = is_flat(out.mesh);
  if (out.is_flat) out.fault = "is flat, of which MuJoCo makes no mesh";
  return out;
}

}  // namespace legwright
