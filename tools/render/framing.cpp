// SPDX-License-Identifier: Apache-2.0
// Automatic cameras: where to stand so that the robot fills the picture.
#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "mjcf/scene/seen_shapes.hpp"
#include "mjcf/scene/surroundings.hpp"
#include "tools/render/posing.hpp"
#include "tools/render/renderer.hpp"

namespace legwright {
namespace {

/// Corners of the boxes about the robot's geoms, in one pose.
void add_corners(const mjModel& model, const mjData& data, std::vector<Eigen::Vector3d>& points) {
  for (int g = 0; g < model.ngeom; ++g) {
    const bool seen = model.geom_rgba[std::ptrdiff_t{4} * g + 3] > 0.0F &&
                      model.geom_group[g] <= kHighestSeenGroup;
    if (model.body_weldid[model.geom_bodyid[g]] == 0 || model.geom_type[g] == mjGEOM_PLANE || !seen)
      continue;
    // Centre and half sizes in the geom's frame.
    const double* box = model.geom_aabb + std::ptrdiff_t{6} * g;
    const double* place = data.geom_xpos + std::ptrdiff_t{3} * g;
    for (int corner = 0; corner < 8; ++corner) {
      double local[3], world[3];
      for (int c = 0; c < 3; ++c)
        local[c] = box[c] + ((corner >> c) & 1 ? box[3 + c] : -box[3 + c]);
      mju_mulMatVec3(world, data.geom_xmat + std::ptrdiff_t{9} * g, local);
      points.emplace_back(place[0] + world[0], place[1] + world[1], place[2] + world[2]);
    }
  }
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double middle() const { return 0.5 * (low + high); }
};

}  // namespace

View frame_robot(const mjModel& model, const Poses& poses, double azimuth, double elevation,
                 double aspect, double margin) {
  const PosedModel robot{&model, &poses};
  return frame_robots({&robot, 1}, azimuth, elevation, aspect, margin);
}

View frame_robots(std::span<const PosedModel> robots, double azimuth, double elevation,
                  double aspect, double margin) {
  std::vector<Eigen::Vector3d> points;
  for (const PosedModel& robot : robots) {
    const DataPointer data(mj_makeData(robot.model));
    for (const auto& qpos : *robot.poses) {
      place(*robot.model, *data, qpos);
      add_corners(*robot.model, *data, points);
    }
  }
  if (points.empty()) throw std::invalid_argument("no robot to point the camera at");

  const double degree = std::numbers::pi / 180.0;
  const double a = azimuth * degree, e = elevation * degree;
  const Eigen::Matrix3d rotation = ground_rotation(*robots.front().model);
  const Eigen::Vector3d forward =
      rotation * Eigen::Vector3d(std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e));
  const Eigen::Vector3d right = forward.cross(rotation.col(2)).normalized();
  const Eigen::Vector3d up = right.cross(forward);
  const double half_height = std::tan(0.5 * kFieldOfView * degree) * (1.0 - margin);
  const double half_width = half_height * aspect;

  Eigen::Vector3d lookat = points.front();
  double distance = 1.0;
  for (int pass = 0; pass < 12; ++pass) {  // centre what is seen, then stand as near as possible
    Range u, v;
    double needed = 0.0;
    for (const auto& point : points) {
      const Eigen::Vector3d from = point - lookat;
      const double depth = std::max(pass == 0 ? 1.0 : distance + forward.dot(from), 0.1 * distance);
      u.add(pass == 0 ? right.dot(from) : right.dot(from) / depth);
      v.add(pass == 0 ? up.dot(from) : up.dot(from) / depth);
      needed = std::max({needed, std::abs(right.dot(from)) / half_width - forward.dot(from),
                         std::abs(up.dot(from)) / half_height - forward.dot(from)});
    }
    const double scale = pass == 0 ? 1.0 : distance;
    lookat += scale * (u.middle() * right + v.middle() * up);
    if (pass == 0) {  // depth is centred once; later passes only move across the line of sight
      Range w;
      for (const auto& point : points) w.add(forward.dot(point - lookat));
      lookat += w.middle() * forward;
    }
    distance = std::max(needed, 0.05);
  }
  return {{lookat.x(), lookat.y(), lookat.z()}, distance, azimuth, elevation};
}

}  // namespace legwright
