// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/foot_words.hpp"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace legwright {
namespace {

constexpr double kAskewTold = 0.5;  // [degrees]

/// By how many degrees a sole is off the level in the home pose of the initial design.
double degrees_askew(const RobotModel& robot, const Foot& foot) {
  const Eigen::VectorXd s = robot.space.initial();
  Eigen::Vector3d normal = foot.sole->ahead.cross(foot.sole->beside);
  const auto& links = robot.morphology.links;
  for (int k = foot.link; k > 0; k = links[static_cast<std::size_t>(k)].parent) {
    const Link& link = links[static_cast<std::size_t>(k)];
    normal =
        link.orientation * (Eigen::AngleAxisd(link.joint.nominal, link.joint.axis.at(s)) * normal);
  }
  return std::acos(std::clamp(normal.z(), -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

std::string part_of_geom(const FootContact& contact) {
  const auto sides = (contact.share.array() != 0.0).count();
  switch (contact.geom_type) {
    case mjGEOM_BOX:
      return sides == 1 ? "face of a box" : sides == 2 ? "edge of a box" : "corner of a box";
    case mjGEOM_CYLINDER:
      return sides == 1 ? "face of a cylinder" : "rim of a cylinder";
    case mjGEOM_ELLIPSOID:
      return "point of an ellipsoid";
    case mjGEOM_MESH:
      return "lowest part of a mesh";
    default:
      return "point";
  }
}

}  // namespace

std::string touching_part(const RobotModel& robot, int index) {
  const Foot& foot = robot.morphology.feet[static_cast<std::size_t>(index)];
  const FootContact& contact = robot.structure.feet[static_cast<std::size_t>(index)];
  const bool is_fork = !contact.others.empty() && contact.geom_type != mjGEOM_SPHERE;
  if (is_fork && !foot.sole)
    return fmt::format("middle of {} plates alike", 1 + contact.others.size());
  if (foot.radius > 0.0) {
    const std::size_t balls = 1 + contact.others.size();
    return fmt::format("{} of {:.3g} mm",
                       balls > 1 ? fmt::format("middle of {} balls", balls) : "ball",
                       1e3 * foot.radius);
  }
  if (!foot.sole) return part_of_geom(contact);
  const double askew = degrees_askew(robot, foot);
  return askew < kAskewTold
             ? "middle of its sole"
             : fmt::format("middle of its sole, drawn {:.1f} degrees askew and laid down", askew);
}

}  // namespace legwright
