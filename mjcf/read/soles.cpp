// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/soles.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mjcf/read/feet.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kTilt = 0.1;       // of a foot's width: so much higher a point may be
constexpr double kNarrow = 0.2;     // of its length: what is narrower is an edge
constexpr int kRim = 8;             // points
constexpr double kEachAlone = 0.2;  // least singular value: the share of a motion that is its own

struct GroundPoint {
  Vector3d place;
  int geom;
};

std::vector<GroundPoint> find_ground_points(const mjModel& model, const mjData& data,
                                            const std::vector<int>& bodies) {
  std::vector<GroundPoint> points;
  for (const int body : bodies)
    for (int k = 0; k < model.body_geomnum[body]; ++k) {
      const int geom = model.body_geomadr[body] + k;
      if (!collides(model, geom)) continue;
      for (const Vector3d& place : surface_points(model, data, geom))
        points.push_back({place, geom});
    }
  if (points.empty()) return points;
  double low = std::numeric_limits<double>::infinity();
  Vector3d least = Vector3d::Constant(low), most = -least;
  for (const GroundPoint& point : points) {
    low = std::min(low, point.place.z());
    least = least.cwiseMin(point.place);
    most = most.cwiseMax(point.place);
  }
  const double width = (most - least).head<2>().minCoeff();
  points.erase(
      std::remove_if(points.begin(), points.end(),
                     [&](const GroundPoint& p) { return p.place.z() > low + kTilt * width; }),
      points.end());
  return points;
}

}  // namespace

std::vector<Vector3d> surface_points(const mjModel& model, const mjData& data, int geom) {
  std::vector<Vector3d> out;
  const Vector3d centre = vector_at(data.geom_xpos, geom), size = vector_at(model.geom_size, geom);
  const Matrix3d axes = matrix_at(data.geom_xmat, geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      out.push_back(centre - size.x() * Vector3d::UnitZ());
      break;
    case mjGEOM_CAPSULE:
      for (const double end : {-1.0, 1.0})
        out.push_back(centre + end * size.y() * axes.col(2) - size.x() * Vector3d::UnitZ());
      break;
    case mjGEOM_CYLINDER:
      for (const double end : {-1.0, 1.0})
        for (int k = 0; k < kRim; ++k) {
          const double angle = 2.0 * std::numbers::pi * k / kRim;
          out.push_back(centre + axes * Vector3d(size.x() * std::cos(angle),
                                                 size.x() * std::sin(angle), end * size.y()));
        }
      break;
    case mjGEOM_BOX:
      for (int corner = 0; corner < 8; ++corner)
        out.push_back(centre +
                      axes * size.cwiseProduct(Vector3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                                                        corner & 4 ? 1 : -1)));
      break;
    case mjGEOM_MESH:
      if (const int mesh = model.geom_dataid[geom]; mesh >= 0)
        for (int v = 0; v < model.mesh_vertnum[mesh]; ++v)
          out.push_back(centre + axes * Eigen::Vector3f::Map(model.mesh_vert +
                                                             3 * static_cast<std::ptrdiff_t>(
                                                                     model.mesh_vertadr[mesh] + v))
                                            .cast<double>());
      break;
    default:
      break;
  }
  return out;
}

std::vector<Vector3d> ground_points(const mjModel& model, const mjData& data,
                                    const std::vector<int>& bodies) {
  std::vector<Vector3d> out;
  for (const GroundPoint& point : find_ground_points(model, data, bodies))
    out.push_back(point.place);
  return out;
}

std::vector<int> ground_geoms(const mjModel& model, const mjData& data,
                              const std::vector<int>& bodies) {
  std::vector<int> out;
  for (const GroundPoint& point : find_ground_points(model, data, bodies))
    if (out.empty() || out.back() != point.geom) out.push_back(point.geom);
  return out;
}

Vector3d middle_of_sole(const std::vector<Vector3d>& points, const Vector3d& normal,
                        const Vector3d& ahead) {
  const Vector3d beside = normal.cross(ahead).normalized(), along = beside.cross(normal);
  Vector3d least = Vector3d::Constant(std::numeric_limits<double>::infinity()), most = -least;
  double height = 0.0;
  for (const Vector3d& point : points) {
    const Vector3d seen(along.dot(point), beside.dot(point), 0.0);
    least = least.cwiseMin(seen);
    most = most.cwiseMax(seen);
    height += normal.dot(point) / static_cast<double>(points.size());
  }
  const Vector3d middle = 0.5 * (least + most);
  return middle.x() * along + middle.y() * beside + height * normal;
}

std::optional<Vector3d> normal_of_sole(const std::vector<Vector3d>& points) {
  if (points.size() < 3) return std::nullopt;
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& point : points) middle += point / static_cast<double>(points.size());
  Matrix3d spread = Matrix3d::Zero();
  for (const Vector3d& point : points) spread += (point - middle) * (point - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(spread);  // rising
  const Vector3d sizes = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  if (sizes[2] == 0.0 || sizes[1] < kNarrow * sizes[2] || sizes[0] > kTilt * sizes[1])
    return std::nullopt;
  const Vector3d normal = axes.eigenvectors().col(0);
  return normal.z() < 0.0 ? Vector3d(-normal) : normal;
}

bool can_lay_down(const mjData& data, const std::vector<int>& joints, const Vector3d& sole,
                  double height) {
  if (joints.size() < 4 || !(height > 0.0)) return false;
  Eigen::Matrix4Xd motion(4, joints.size());
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const Vector3d axis = vector_at(data.xaxis, joints[k]),
                   anchor = vector_at(data.xanchor, joints[k]);
    const auto column = static_cast<Eigen::Index>(k);
    motion.col(column) << axis.cross(sole - anchor).head<2>() / height, axis.head<2>();
  }
  const Eigen::Matrix4d squares =
      motion * motion.transpose();  // eigenvalues: squares of the singular values
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(squares).eigenvalues()[0] >
         kEachAlone * kEachAlone;
}

}  // namespace legwright
