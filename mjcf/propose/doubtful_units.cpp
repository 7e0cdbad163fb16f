// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/doubtful_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjcf/text/angle_words.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/listed.hpp"
#include "mjcf/text/model_arrays.hpp"
#include "optimizer/design/kinematics.hpp"

namespace legwright {
namespace {

constexpr double kLongestLeg = 10.0;  // [m]; large robots have some 1.5
// [kg/m³]: mass over the cube of a leg's length. Robots of 1 to 130 kg have 50 to 1500, in grams a
// thousand times as much.
constexpr double kDensest = 2e4;
// Of what carries the robot on stretched legs; strong legs have some ten times that.
constexpr double kPlaceholder = 20.0;
constexpr double kOtherUnit = 30.0;                      // times as long: no leg is drawn so
constexpr double kWidestRange = 4.0 * std::numbers::pi;  // [rad], either way

std::string of_ranges(const RobotModel& robot) {
  int count = 0;
  std::string first;
  double end = 0.0;
  for (const Link& link : robot.morphology.links) {
    const double far = std::max(std::isfinite(link.joint.lower) ? std::abs(link.joint.lower) : 0.0,
                                std::isfinite(link.joint.upper) ? std::abs(link.joint.upper) : 0.0);
    if (far <= kWidestRange) continue;
    if (count++ == 0) {
      first = link.joint.name;
      end = far;
    }
  }
  if (count == 0) return "";
  return fmt::format("the range of joint '{}'{} goes to {}, {:.2g} turns: {}", first,
                     count == 1 ? "" : fmt::format(", as of {} more,", count - 1),
                     angle_text(end, robot.in_degrees), end / (2.0 * std::numbers::pi),
                     robot.in_degrees
                         ? "no leg turns so far; write what this joint does, in degrees"
                         : "it seems to be in degrees; write it in the unit that the file says (a "
                           "URDF has rad)");
}

std::string of_torques(const RobotModel& robot) {
  const double carries = carrying_torque(robot.morphology);
  std::vector<std::string> names;
  double most = 0.0;
  for (const Servo& servo : robot.servos) {
    if (!servo.tendon.empty() || !(servo.torque_limit > kPlaceholder * carries)) continue;
    if (!std::isfinite(servo.torque_limit)) continue;  // nobody gave it one
    names.push_back(servo.joint);
    most = std::max(most, servo.torque_limit);
  }
  if (names.empty()) return "";
  return fmt::format(
      "torque limits of {:.3g} N m ({}) are {:.3g} times what carries the robot on stretched legs: "
      "they seem to be placeholders, with which no plan is too strong for its motors and no "
      "verdict "
      "tells so; write what the motors give",
      most, listed(names), most / carries);
}

/// How far the geoms of a body, and the bodies that hang on it, are from it [m].
std::vector<double> reach_of_bodies(const mjModel& model) {
  std::vector<double> reach(static_cast<std::size_t>(model.nbody), 0.0);
  const auto raise = [&](int body, double to) {
    double& known = reach[static_cast<std::size_t>(body)];
    known = std::max(known, to);
  };
  for (int b = 1; b < model.nbody; ++b)
    raise(model.body_parentid[b], vector_at(model.body_pos, b).norm());
  for (int g = 0; g < model.ngeom; ++g)
    raise(model.geom_bodyid[g], vector_at(model.geom_pos, g).norm() + model.geom_rbound[g]);
  return reach;
}

int depth_below(const mjModel& model, int trunk, int body) {
  int depth = 0;
  for (; body != trunk; body = model.body_parentid[body]) ++depth;
  return depth;
}

/// One link that is many times as long as those that are built alike in the other legs.
std::string of_one_link(const mjModel& model, int trunk) {
  const std::vector<double> reach = reach_of_bodies(model);
  int longest = -1;
  for (int b = trunk + 1; b < model.nbody; ++b)
    if (model.body_rootid[b] == trunk &&
        (longest < 0 ||
         reach[static_cast<std::size_t>(b)] > reach[static_cast<std::size_t>(longest)]))
      longest = b;
  if (longest < 0) return "";
  std::vector<std::string> alike;
  double other = 0.0;
  for (int b = trunk + 1; b < model.nbody; ++b) {
    if (b == longest || model.body_rootid[b] != trunk ||
        depth_below(model, trunk, b) != depth_below(model, trunk, longest) ||
        model.body_geomnum[b] != model.body_geomnum[longest] ||
        model.body_jntnum[b] != model.body_jntnum[longest])
      continue;
    alike.push_back(name_of(model, mjOBJ_BODY, b));
    other = std::max(other, reach[static_cast<std::size_t>(b)]);
  }
  const double own = reach[static_cast<std::size_t>(longest)];
  if (alike.empty() || !(other > 0.0) || own < kOtherUnit * other) return "";
  const bool millimetres = own > kOtherUnit * kOtherUnit / 3.0 * other;
  return fmt::format(
      "link '{}' is {:.3g} m long, {:.0f} times as long as those like it ({}): one of its numbers "
      "seems to be in {}; multiply that by {}",
      name_of(model, mjOBJ_BODY, longest), own, own / other, listed(alike),
      millimetres ? "millimetres" : "centimetres", millimetres ? 0.001 : 0.01);
}

}  // namespace

double carrying_torque(const Morphology& morphology) {
  return kGravity * morphology.total_mass() / morphology.foot_count() * morphology.leg_length;
}

std::vector<std::string> doubtful_units(const RobotModel& robot, const std::vector<Limb>& limbs) {
  std::vector<std::string> out;
  double leg = 0.0;
  for (const Limb& limb : limbs)
    leg = std::max(leg, stretched_limb(robot.morphology, limb.foot, robot.space.initial()));
  const ModelPointer model = compile_mjcf(robot.xml, robot.file);
  const double mass = model->body_subtreemass[robot.structure.trunk];
  if (std::string one = of_one_link(*model, robot.structure.trunk); !one.empty())
    out.push_back(std::move(one));
  else if (leg > kLongestLeg)
    out.push_back(
        fmt::format("its legs are {:.3g} m long: lengths seem to be in millimetres or centimetres; "
                    "multiply them by 0.001 or 0.01",
                    leg));
  else if (leg > 0.0 && mass > kDensest * leg * leg * leg)
    out.push_back(fmt::format(
        "it has {:.3g} kg on legs of {:.2g} m, more than solid steel would: masses seem "
        "to be in grams; multiply them, and moments of inertia, by 0.001",
        mass, leg));
  if (std::string ranges = of_ranges(robot); !ranges.empty()) out.push_back(std::move(ranges));
  if (std::string torques = of_torques(robot); !torques.empty()) out.push_back(std::move(torques));
  return out;
}

}  // namespace legwright
