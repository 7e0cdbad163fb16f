// SPDX-License-Identifier: Apache-2.0
#include "tools/task/support_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "optimizer/motion/home_stance.hpp"

namespace legwright {
namespace {

using Eigen::Vector2d;

// Of the feet's mean distance from the centre of mass: from there on no step is short enough.
constexpr double kOutside = 0.15, kBesideTheLine = 0.3;
constexpr double kAcross = 0.2;  // of that distance: feet nearer along x share a row

/// How far the origin is outside of the convex hull of points; 0 within.
double outside(const std::vector<Vector2d>& points) {
  std::vector<Vector2d> directions = points;
  for (const Vector2d& a : points)
    for (const Vector2d& b : points)
      directions.emplace_back(b.y() - a.y(), a.x() - b.x());  // both normals, over all pairs
  double most = 0.0;
  for (const Vector2d& direction : directions) {
    if (!(direction.norm() > 0.0)) continue;
    const Vector2d n = direction.normalized();
    double least = n.dot(points.front());
    for (const Vector2d& point : points) least = std::min(least, n.dot(point));
    most = std::max(most, least);
  }
  return most;
}

/// Whether two feet are those of a pace or a bound.
bool beside_each_other(const Vector2d& a, const Vector2d& b, double size) {
  return a.y() * b.y() > 0.0 || std::abs(a.x() - b.x()) < kAcross * size;
}

}  // namespace

std::string unsupported_stance(const Task& task, const RobotModel& robot) {
  const Morphology& body = robot.morphology;
  const StyleTargets home = home_stance(body, robot.space.initial());
  double size = 0.0;
  for (const Vector2d& foot : home.footprint) size += foot.norm() / body.foot_count();
  std::set<std::vector<int>> stances;
  for (int knot = 0; knot < task.gait.knot_count(); ++knot) {
    std::vector<int> stance;
    for (int foot = 0; foot < body.foot_count(); ++foot)
      if (task.gait.in_contact(knot, foot)) stance.push_back(foot);
    stances.insert(stance);
  }
  double worst = 0.0;
  std::string words;
  for (const std::vector<int>& stance : stances) {
    if (stance.size() < 2) continue;
    std::vector<Vector2d> points;
    std::vector<std::string> names;
    bool soles = false;
    for (const int foot : stance) {
      points.push_back(home.footprint[static_cast<std::size_t>(foot)]);
      names.push_back(body.feet[static_cast<std::size_t>(foot)].name);
      soles = soles || body.feet[static_cast<std::size_t>(foot)].sole;
    }
    const bool pair = stance.size() == 2;
    if (soles || (pair && beside_each_other(points[0], points[1], size))) continue;
    const double far = outside(points), over = far / ((pair ? kBesideTheLine : kOutside) * size);
    if (over <= std::max(1.0, worst)) continue;
    worst = over;
    words = fmt::format(
        "while {} stand, the centre of mass is {:.2g} m outside of their support in the home pose, "
        "and the robot tips: are these feet where the gait has them (`legwright check` draws it), "
        "and which way is forward? Else another gait, or feet farther apart",
        fmt::join(names, ", "), far);
  }
  return words;
}

}  // namespace legwright
