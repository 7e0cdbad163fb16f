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

constexpr double kTilt = 0.1;        // of a foot's width: so much higher a point may be
constexpr double kAskew = 0.09;      // sine of the angle by which a sole may be drawn askew
constexpr double kLevelSole = 0.95;  // cosine of the angle from which on it is an edge that touches
constexpr double kNarrow = 0.2;      // of its length: what is narrower is an edge
constexpr int kRim = 8;              // points
constexpr double kEachAlone = 0.2;   // least singular value: the share of a motion that is its own

struct GroundPoint {
  Vector3d place;
  int geom;
};

/// Whether a point is above another one rather than beside it: on the upper face of a sole.
bool is_above(const Vector3d& point, const Vector3d& other) {
  const double rise = point.z() - other.z();
  return rise > 0.0 && (point - other).head<2>().norm() < rise;
}

bool is_mesh(const mjModel& model, const GroundPoint& point) {
  return model.geom_type[point.geom] == mjGEOM_MESH;
}

/// Points on which none of the others is below: what can touch. Vertices of meshes are many, and
/// count by their height alone.
std::vector<GroundPoint> lower_faces(const mjModel& model, const std::vector<GroundPoint>& points) {
  std::vector<GroundPoint> out;
  for (const GroundPoint& point : points)
    if (is_mesh(model, point) ||
        std::none_of(points.begin(), points.end(),
                     [&](const GroundPoint& other) { return is_above(point.place, other.place); }))
      out.push_back(point);
  return out;
}

std::vector<Vector3d> places_of(const std::vector<GroundPoint>& points) {
  std::vector<Vector3d> out;
  out.reserve(points.size());
  for (const GroundPoint& point : points) out.push_back(point.place);
  return out;
}

/// The points about as low as the lowest one; where these are no sole, but those are of one that is
/// drawn askew, so that the lowest one touches alone, the latter.
std::vector<GroundPoint> touching(const mjModel& model, const std::vector<GroundPoint>& points) {
  Vector3d least = points.front().place, most = least, lowest = least;
  for (const GroundPoint& point : points) {
    if (point.place.z() < lowest.z()) lowest = point.place;
    least = least.cwiseMin(point.place);
    most = most.cwiseMax(point.place);
  }
  const double width = (most - least).head<2>().minCoeff();
  std::vector<GroundPoint> level, askew;
  for (const GroundPoint& point : lower_faces(model, points)) {
    const double rise = point.place.z() - lowest.z();
    if (rise <= kTilt * width) level.push_back(point);
    if (!is_mesh(model, point) && rise <= kAskew * (point.place - lowest).norm())
      askew.push_back(point);
  }
  return !normal_of_sole(places_of(level)) && normal_of_sole(places_of(askew)) ? askew : level;
}

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
  return points.empty() ? points : touching(model, points);
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
  return places_of(find_ground_points(model, data, bodies));
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
  if (std::abs(normal.z()) < kLevelSole) return std::nullopt;
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
