// SPDX-License-Identifier: Apache-2.0
#include "mjcf/read/foot_words.hpp"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjcf/read/moving_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

constexpr double kAskewTold = 0.5;  // [degrees]

double degrees_off_level(const Eigen::Vector3d& normal) {
  return std::acos(std::clamp(std::abs(normal.z()), 0.0, 1.0)) * 180.0 / std::numbers::pi;
}

/// By how many degrees a sole is off the level in the home pose of the initial design.
double sole_askew(const RobotModel& robot, const Foot& foot) {
  const Eigen::VectorXd s = robot.space.initial();
  Eigen::Vector3d normal = foot.sole->ahead.cross(foot.sole->beside);
  const auto& links = robot.morphology.links;
  for (int k = foot.link; k > 0; k = links[static_cast<std::size_t>(k)].parent) {
    const Link& link = links[static_cast<std::size_t>(k)];
    normal =
        link.orientation * (Eigen::AngleAxisd(link.joint.nominal, link.joint.axis.at(s)) * normal);
  }
  return degrees_off_level(normal);
}

/// The same of the face of a box or cylinder that no hinge lays down; 0 of other parts.
double face_askew(const RobotModel& robot, const FootContact& contact) {
  Eigen::Index along = 0;
  const bool has_faces = contact.geom_type == mjGEOM_BOX || contact.geom_type == mjGEOM_CYLINDER;
  if (!has_faces || contact.geom < 0 || (contact.share.array() != 0.0).count() != 1) return 0.0;
  contact.share.cwiseAbs().maxCoeff(&along);
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  const DataPointer data = kinematics_at(*model, home_qpos(*model), robot.file);
  return degrees_off_level(matrix_at(data->geom_xmat, contact.geom).col(along));
}

std::string drawn_askew(double degrees, const char* laid) {
  return degrees < kAskewTold ? "" : fmt::format(", drawn {:.1f} degrees askew{}", degrees, laid);
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
  if (!foot.sole) return part_of_geom(contact) + drawn_askew(face_askew(robot, contact), "");
  return "middle of its sole" + drawn_askew(sole_askew(robot, foot), " and laid down");
}

}  // namespace legwright
