// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/odd_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "mjcf/propose/facing.hpp"
#include "mjcf/read/limbs.hpp"
#include "mjcf/text/angle_words.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/listed.hpp"
#include "mjcf/text/model_arrays.hpp"

namespace legwright {
namespace {

constexpr std::size_t kFewest = 3;   // legs among which one is the odd one
constexpr double kLateral = 0.9;     // of an axis across the robot
constexpr double kOneSided = 0.1;    // [rad]: ends of a range that differ less from a mirrored one
constexpr double kSameRange = 1e-6;  // [rad]

/// The joints in one place of all legs of one build.
struct JointsAlike {
  std::vector<const Joint*> joints;
  std::vector<Eigen::Vector3d> axes;  // at angle zero, in the trunk's frame
};

bool has_range(const Joint& joint) {
  return std::isfinite(joint.lower) || std::isfinite(joint.upper);
}

std::vector<std::string> names_but(const JointsAlike& place, std::size_t odd) {
  std::vector<std::string> out;
  for (std::size_t k = 0; k < place.joints.size(); ++k)
    if (k != odd) out.push_back(place.joints[k]->name);
  return out;
}

/// One joint that has no range where the others have, or has one where they have none.
std::string odd_range(const JointsAlike& place, bool in_degrees) {
  const auto with =
      static_cast<std::size_t>(std::count_if(place.joints.begin(), place.joints.end(),
                                             [](const Joint* joint) { return has_range(*joint); }));
  const bool lacks = with + 1 == place.joints.size();
  if (!lacks && with != 1) return "";
  std::size_t odd = 0;
  while (has_range(*place.joints[odd]) == lacks) ++odd;
  if (!lacks)
    return fmt::format(
        "joint '{}' has a range ({}), those in its place in the other legs have none ({}); write "
        "theirs, or take it out, if that is not meant",
        place.joints[odd]->name,
        angle_range_text(place.joints[odd]->lower, place.joints[odd]->upper, in_degrees),
        listed(names_but(place, odd)));
  const Joint& other = *place.joints[odd == 0 ? 1 : 0];
  return fmt::format(
      "joint '{}' has no range, those in its place in the other legs have ({}; {}: {}): any angle "
      "is planned for it; write its range",
      place.joints[odd]->name, listed(names_but(place, odd)), other.name,
      angle_range_text(other.lower, other.upper, in_degrees));
}

/// Where the legs are straight at angle zero, which way a joint bends them is told by the sign of
/// its axis and its range together. @param side the lateral direction
std::string bent_the_other_way(const JointsAlike& place, const mjModel& model, int side) {
  std::vector<std::pair<double, double>> ways;
  for (std::size_t k = 0; k < place.joints.size(); ++k) {
    const Joint& joint = *place.joints[k];
    const double across = place.axes[k][side];
    if (std::abs(across) < kLateral || !std::isfinite(joint.lower) || !std::isfinite(joint.upper) ||
        std::abs(joint.lower + joint.upper) < kOneSided)
      return "";
    ways.emplace_back(across > 0.0 ? std::pair(joint.lower, joint.upper)
                                   : std::pair(-joint.upper, -joint.lower));
  }
  const auto same = [](const std::pair<double, double>& a, const std::pair<double, double>& b) {
    return std::abs(a.first - b.first) < kSameRange && std::abs(a.second - b.second) < kSameRange;
  };
  // Of three legs or more one differs from the first, or the first from all.
  const std::pair<double, double> usual = same(ways[0], ways[1]) ? ways[0] : ways[2];
  std::size_t odd = 0, differing = 0;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (same(ways[k], usual)) continue;
    odd = k;
    ++differing;
  }
  const auto turned = [](const std::pair<double, double>& way) {
    return std::pair(-way.second, -way.first);
  };
  if (differing != 1 || !same(turned(ways[odd]), usual)) return "";
  const auto axis_text = [&](const Joint& joint) {
    const int id = mj_name2id(&model, mjOBJ_JOINT, joint.name.c_str());
    const Eigen::Vector3d axis = vector_at(model.jnt_axis, id);
    return fmt::format("{:.3g} {:.3g} {:.3g}", axis.x(), axis.y(), axis.z());
  };
  const Joint &one = *place.joints[odd], &other = *place.joints[odd == 0 ? 1 : odd - 1];
  return fmt::format(
      "joint '{}' turns about {} of its body and bends its leg the other way than {} ('{}' about "
      "{}): turn the sign of its axis, or of its range, if that is not meant",
      one.name, axis_text(one), listed(names_but(place, odd)), other.name, axis_text(other));
}

/// The speed at which a joint's damping takes all that its motor gives [rad/s].
double damped_speed(const Joint& joint, std::optional<double> limit) {
  const double torque = std::min(joint.torque_limit, limit.value_or(joint.torque_limit));
  if (!(joint.damping > 0.0) || !std::isfinite(torque))
    return std::numeric_limits<double>::infinity();
  return std::max(0.0, torque - joint.friction_loss) / joint.damping;
}

}  // namespace

std::vector<std::string> odd_joints(const RobotModel& robot) {
  const Facing facing = facing_of(robot);
  const std::vector<Limb> limbs = find_limbs(robot.morphology, robot.space.initial(), facing.ahead);
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  const DataPointer data = kinematics_at(*model, nullptr, robot.file);  // at angle zero
  const Eigen::Matrix3d trunk = matrix_at(data->xmat, robot.structure.trunk);
  std::map<std::pair<std::size_t, std::size_t>, JointsAlike> places;  // by a leg's joints
  for (const Limb& limb : limbs)
    for (auto k = static_cast<std::size_t>(limb.shared); k < limb.links.size(); ++k) {
      const Joint& joint = robot.morphology.links[static_cast<std::size_t>(limb.links[k])].joint;
      JointsAlike& place = places[{limb.links.size(), k}];
      const int id = mj_name2id(model.get(), mjOBJ_JOINT, joint.name.c_str());
      place.joints.push_back(&joint);
      place.axes.emplace_back(trunk.transpose() * vector_at(data->xaxis, id));
    }
  std::vector<std::string> out;
  for (const auto& [key, place] : places) {
    if (place.joints.size() < kFewest) continue;
    if (std::string told = odd_range(place, robot.in_degrees); !told.empty())
      out.push_back(std::move(told));
    const int side = static_cast<int>(sides_across(facing.ahead));
    if (std::string told = bent_the_other_way(place, *model, side); !told.empty())
      out.push_back(std::move(told));
  }
  return out;
}

std::string unlimited_torques(const RobotModel& robot) {
  std::vector<std::string> names;
  for (const Servo& servo : robot.servos)
    if (!std::isfinite(servo.torque_limit)) names.push_back(servo.joint);
  if (names.empty()) return "";
  return fmt::format(
      "{} ({}) without a torque limit: no plan is too strong for {}, and no verdict tells so; "
      "write "
      "forcerange in the file",
      names.size() == 1 ? "a motor" : fmt::format("{} motors", names.size()), listed(names),
      names.size() == 1 ? "it" : "them");
}

double damped_joint_speed(const RobotModel& robot, std::optional<double> limit, double most) {
  double slowest = most;
  for (const Link& link : robot.morphology.links)
    slowest = std::min(slowest, damped_speed(link.joint, limit));
  return slowest;
}

std::string overdamped_joints(const RobotModel& robot, std::optional<double> limit, double needed) {
  std::vector<std::string> names;
  std::string most;
  double slowest = needed;
  for (const Link& link : robot.morphology.links) {
    const Joint& joint = link.joint;
    const double fastest = damped_speed(joint, limit);
    if (fastest < needed) names.push_back(joint.name);
    if (fastest >= slowest) continue;
    slowest = fastest;
    most = fmt::format(
        "that of joint '{}' is {:.3g} N m s/rad, so that its motor of {:.3g} N m{} "
        "turns it at {:.2g} rad/s at most",
        joint.name, joint.damping, std::min(joint.torque_limit, limit.value_or(joint.torque_limit)),
        joint.friction_loss > 0.0
            ? fmt::format(", less {:.3g} N m of dry friction,", joint.friction_loss)
            : "",
        fastest);
  }
  if (names.empty()) return "";
  return fmt::format(
      "damping leaves joints slower than a gait of usual speed ({}): {}; a slow gait with a long "
      "cycle may do, as the first task of init has it, else lower the damping or, where the motor "
      "is stronger, raise its limit (forcerange)",
      listed(names), most);
}

}  // namespace legwright
