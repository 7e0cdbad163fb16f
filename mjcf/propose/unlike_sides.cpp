// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/unlike_sides.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "mjcf/propose/facing.hpp"
#include "mjcf/read/mirror.hpp"
#include "mjcf/text/angle_words.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/listed.hpp"
#include "optimizer/design/kinematics.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kNear = 0.3;  // of the leg length: feet farther from a mirror image are none
constexpr double kMirroredAxes = 0.01;   // [rad]: what exporters round, and hands
constexpr double kMirroredRanges = 0.1;  // [rad]
constexpr double kTold = 1e-4;           // [m]: what differs by less was rounded

const Link& link_of(const RobotModel& robot, int index) {
  return robot.morphology.links[static_cast<std::size_t>(index)];
}

/// From the joint of a limb's k-th link to the next one, or to the foot [m].
double link_length(const RobotModel& robot, const Limb& limb, std::size_t k, const VectorXd& s) {
  return k + 1 < limb.links.size()
             ? link_of(robot, limb.links[k + 1]).origin.at(s).norm()
             : robot.morphology.feet[static_cast<std::size_t>(limb.foot)].position.at(s).norm();
}

/// Calls with each link of a pair of limbs and its twin on the other side.
void for_each_pair(const std::vector<Limb>& limbs,
                   const std::function<void(const Limb&, const Limb&, std::size_t)>& look) {
  for (std::size_t a = 0; a < limbs.size(); ++a) {
    const int b = limbs[a].partner;
    if (b <= static_cast<int>(a)) continue;
    const Limb& other = limbs[static_cast<std::size_t>(b)];
    for (auto k = static_cast<std::size_t>(limbs[a].shared); k < limbs[a].links.size(); ++k)
      look(limbs[a], other, k);
  }
}

/// How far a limb's foot is off the mirror image of another's in the home pose [m].
Vector3d off_mirror(const Limb& one, const Limb& other, Across across, double middle) {
  return one.home - point_in_mirror(other.home, across, middle);
}

/// Between the hips of two limbs, or `otherwise` where these hang at no trunk [m].
double middle_of_hips(const RobotModel& robot, const Limb& one, const Limb& other, Across across,
                      double otherwise, const VectorXd& s) {
  const Link &first = link_of(robot, one.links[0]), &twin = link_of(robot, other.links[0]);
  if (first.parent != 0 || twin.parent != 0) return otherwise;
  const auto side = static_cast<int>(across);
  return 0.5 * (first.origin.at(s)[side] + twin.origin.at(s)[side]);
}

/// "links 'FL_thigh' and 'FR_thigh'"; of the last length, which ends where a foot touches, "feet".
std::string pair_named(const RobotModel& robot, const Limb& one, const Limb& other, std::size_t k) {
  const auto named = [&](const Limb& limb) -> const std::string& {
    return k + 1 < limb.links.size()
               ? link_of(robot, limb.links[k]).name
               : robot.morphology.feet[static_cast<std::size_t>(limb.foot)].name;
  };
  return fmt::format("{} '{}' and '{}'", k + 1 < one.links.size() ? "links" : "feet", named(one),
                     named(other));
}

/// Of a pair of links that differ in length by more than is tied; empty where they do not.
std::string unlike_lengths(const RobotModel& robot, const Limb& one, const Limb& other,
                           std::size_t k, const VectorXd& s) {
  const double length = link_length(robot, one, k, s), twins = link_length(robot, other, k, s);
  if (std::abs(twins - length) <= std::max(kTold, kTiedInProportion * length)) return "";
  return k + 1 < one.links.size()
             ? fmt::format("{} differ in length, {:.4g} and {:.4g} m",
                           pair_named(robot, one, other, k), length, twins)
             : fmt::format("{} are {:.4g} and {:.4g} m from the last joints of their legs",
                           pair_named(robot, one, other, k), length, twins);
}

std::vector<std::string> nearly_mirrored(const RobotModel& robot, const std::vector<Limb>& limbs,
                                         Across across) {
  std::vector<std::string> out;
  const double middle = middle_of_sides(limbs, across);
  const auto foot_of = [&](const Limb& limb) -> const Foot& {
    return robot.morphology.feet[static_cast<std::size_t>(limb.foot)];
  };
  for (std::size_t a = 0; a < limbs.size(); ++a)
    for (std::size_t b = a + 1; b < limbs.size(); ++b) {
      const Limb &one = limbs[a], &other = limbs[b];
      const auto side = static_cast<int>(across);
      const bool opposite = (one.home[side] - middle) * (other.home[side] - middle) < 0.0;
      if (one.partner >= 0 || other.partner >= 0 || !opposite ||
          one.links.size() != other.links.size())
        continue;
      const Vector3d off = off_mirror(one, other, across, middle);
      if (off.norm() > kNear * stretched_limb(robot.morphology, one.foot, robot.space.initial()))
        continue;
      std::string unlike;
      for (auto k = static_cast<std::size_t>(one.shared); k < one.links.size(); ++k)
        if (const std::string why = unlike_lengths(robot, one, other, k, robot.space.initial());
            !why.empty())
          unlike += (unlike.empty() ? ": " : ", ") + why;
      out.push_back(fmt::format(
          "feet '{}' and '{}' would be mirror images but for {:.1f}, {:.1f}, {:.1f} mm along x, y, "
          "z of the trunk in the home pose{}, so nothing ties their legs; mend the file if that is "
          "not meant",
          foot_of(one).name, foot_of(other).name, 1e3 * off.x(), 1e3 * off.y(), 1e3 * off.z(),
          unlike));
    }
  return out;
}

/// Why two joints, whose axes are mirror images, have no mirrored ranges; empty where they
/// have, or one has none.
std::string unmirrored_ranges(const RobotModel& robot, const mjModel& model, const Joint& joint,
                              const Joint& twin, Across across) {
  for (const double end : {joint.lower, joint.upper, twin.lower, twin.upper})
    if (!std::isfinite(end)) return "";
  const VectorXd s = robot.space.initial();
  const int from = mj_name2id(&model, mjOBJ_JOINT, joint.name.c_str()),
            to = mj_name2id(&model, mjOBJ_JOINT, twin.name.c_str());
  const bool alike = mirrored_turn(model, robot.structure.trunk, from, to, across, joint.axis.at(s))
                         .dot(twin.axis.at(s)) > 0.0;
  // Where the zeros of two joints are drawn differently, ranges are so about the home pose alone.
  const auto mirrored_about = [&](double middle, double twins) {
    const double lower = alike ? joint.lower - middle : middle - joint.upper,
                 upper = alike ? joint.upper - middle : middle - joint.lower;
    return std::abs(twins + lower - twin.lower) < kMirroredRanges &&
           std::abs(twins + upper - twin.upper) < kMirroredRanges;
  };
  if (mirrored_about(0.0, 0.0) || mirrored_about(joint.nominal, twin.nominal)) return "";
  return fmt::format("the ranges of '{}' and '{}', {} and {}, are no mirror images", joint.name,
                     twin.name, angle_range_text(joint.lower, joint.upper, robot.in_degrees),
                     angle_range_text(twin.lower, twin.upper, robot.in_degrees));
}

}  // namespace

std::string unmirrored_axes(const RobotModel& robot, const mjModel& model, const Joint& joint,
                            const Joint& twin, Across across) {
  const VectorXd s = robot.space.initial();
  const int from = mj_name2id(&model, mjOBJ_JOINT, joint.name.c_str()),
            to = mj_name2id(&model, mjOBJ_JOINT, twin.name.c_str());
  // The mirror image of a line; a joint may turn either way about it.
  const Vector3d image = mirrored_turn(model, robot.structure.trunk, from, to, across,
                                       joint.axis.at(s)),
                 axis = twin.axis.at(s);
  const double off = std::atan2(image.cross(axis).norm(), std::abs(image.dot(axis)));
  if (off <= kMirroredAxes) return "";
  return fmt::format(
      "the axes of '{}' and '{}' are no mirror images, seen from the trunk in the home pose: "
      "{:.3g} "
      "degrees off",
      joint.name, twin.name, off * 180.0 / std::numbers::pi);
}

std::vector<std::string> unlike_sides(const RobotModel& robot, const std::vector<Limb>& limbs,
                                      Across across) {
  std::vector<std::string> out = nearly_mirrored(robot, limbs, across);
  const VectorXd s = robot.space.initial();
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  for_each_pair(limbs, [&](const Limb& one, const Limb& other, std::size_t k) {
    const Link &link = link_of(robot, one.links[k]), &twin = link_of(robot, other.links[k]);
    std::string axes = unmirrored_axes(robot, *model, link.joint, twin.joint, across);
    if (axes.empty()) axes = unmirrored_ranges(robot, *model, link.joint, twin.joint, across);
    for (const std::string& why : {unlike_lengths(robot, one, other, k, s), axes})
      if (!why.empty()) out.push_back(why + "; mend the file if that is not meant");
  });
  return out;
}

std::vector<std::string> unlike_sides(const RobotModel& robot) {
  const Facing facing = facing_of(robot);
  return unlike_sides(robot, find_limbs(robot.morphology, robot.space.initial(), facing.ahead),
                      sides_across(facing.ahead));
}

std::string tied_though_unlike(const RobotModel& robot, const std::vector<Limb>& limbs,
                               Across across) {
  const VectorXd s = robot.space.initial();
  const double middle = middle_of_sides(limbs, across);
  std::vector<std::string> apart;
  std::set<std::pair<int, int>> seen;  // pairs of feet
  for_each_pair(limbs, [&](const Limb& one, const Limb& other, std::size_t k) {
    const double length = link_length(robot, one, k, s), twins = link_length(robot, other, k, s),
                 between = middle_of_hips(robot, one, other, across, middle, s),
                 off = off_mirror(one, other, across, between).norm();
    if (const double by = std::abs(twins - length); by >= kTold && by <= kTiedInProportion * length)
      apart.push_back(fmt::format(
          "{} are {:.3g} and {:.3g} mm {}", pair_named(robot, one, other, k), 1e3 * length,
          1e3 * twins, k + 1 < one.links.size() ? "long" : "from the last joints of their legs"));
    if (seen.insert({one.foot, other.foot}).second && off >= kTold)
      apart.push_back(fmt::format("feet '{}' and '{}' stand {:.3g} mm off",
                                  robot.morphology.feet[static_cast<std::size_t>(one.foot)].name,
                                  robot.morphology.feet[static_cast<std::size_t>(other.foot)].name,
                                  1e3 * off));
  });
  if (apart.empty()) return "";
  return fmt::format(
      "taken for mirror images and tied, though {}; mend the file if that is not meant",
      listed(apart));
}

}  // namespace legwright
