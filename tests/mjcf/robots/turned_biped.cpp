// SPDX-License-Identifier: Apache-2.0
#include "tests/mjcf/robots/turned_biped.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tests/mjcf/robots/mjcf_builder.hpp"

namespace legwright::test {
namespace {

constexpr double kToesOut = 0.3, kPitch = -0.4, kKnee = 0.8;  // at home, of the left leg [rad]

/// @param turn of the hip's frame about z, which its parts take back; @param drawn more of it,
/// which the yaw hinge takes back
std::string turned_leg(const char* side, double y, double turn, double drawn) {
  const double c = std::cos(turn), s = std::sin(turn);
  const auto at = [&](double x, double z) { return fmt::format("{} {} {}", c * x, -s * x, z); };
  const std::string pitch = fmt::format("{} {} 0", s, c), name = side;
  const auto body = [&](const char* part, const std::string& place) {
    return fmt::format("name=\"{}_{}\" pos=\"{}\"", side, part, place);
  };
  return chain({
      {body("hip", fmt::format("0 {} -0.05", y)) + fmt::format(" euler=\"0 0 {}\"", turn + drawn),
       {hinge(name + "_yaw", "0 0 1"), inertial("0 0 0", 0.4, "0.0004 0.0004 0.0004")}},
      {body("thigh", at(0.03, -0.02)),
       {hinge(name + "_pitch", pitch), inertial(at(0, -0.1), 1.2, "0.01 0.01 0.01")}},
      {body("shank", at(0.01, -0.25)),
       {hinge(name + "_knee", pitch), inertial(at(0, -0.1), 0.8, "0.006 0.006 0.006"),
        fmt::format("<geom name=\"{}_ball\" size=\"0.02\" pos=\"{}\"/>", side, at(0.02, -0.25))}},
  });
}

}  // namespace

std::string turned_biped(const TurnedBiped& how) {
  std::string servos =
      for_each_joint("<position joint=\"{0}_{1}\" kp=\"200\" forcerange=\"-80 80\"/>\n    ",
                     {"left", "right"}, {"yaw", "pitch", "knee"});
  if (how.waist) servos = "<position joint=\"waist\" kp=\"200\" forcerange=\"-80 80\"/>" + servos;
  return fmt::format(R"(<mujoco model="turned_biped">
  <compiler angle="radian"/>
  <worldbody>
    <body name="pelvis" pos="0 0 0.6">
      <freejoint/>
      <inertial pos="0 0 0.1" mass="8" diaginertia="0.1 0.08 0.05"/>{}{}{}{}
    </body>
  </worldbody>
  <actuator>
    {}
  </actuator>
  <keyframe>
    <key name="home" qpos="0 0 0.56 1 0 0 0 {} {} {} {} {} {} {}"/>
  </keyframe>
</mujoco>
)",
                     how.waist ? "<body name=\"abdomen\">" + hinge("waist", "0 0 1") +
                                     inertial("0 0 0", 1, "0.01 0.01 0.01")
                               : "",
                     turned_leg("left", 0.1, 0.0, 0.0),
                     turned_leg("right", -0.1, how.turn, how.zero), how.waist ? "</body>" : "",
                     servos, how.waist ? "0" : "", kToesOut, kPitch, kKnee, -kToesOut - how.zero,
                     kPitch, kKnee);
}

}  // namespace legwright::test
