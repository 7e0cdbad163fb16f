// SPDX-License-Identifier: Apache-2.0
#include "tests/mjcf/robots/turned_biped.hpp"

#include <fmt/format.h>

#include <cmath>

namespace legwright::test {
namespace {

constexpr double kToesOut = 0.3, kPitch = -0.4, kKnee = 0.8;  // at home, of the left leg [rad]

/// @param turn of the hip's frame about z, which its parts take back; @param drawn more of it,
/// which the yaw hinge takes back
std::string leg(const char* side, double y, double turn, double drawn) {
  const double c = std::cos(turn), s = std::sin(turn);
  const auto at = [&](double x, double z) { return fmt::format("{} {} {}", c * x, -s * x, z); };
  const std::string pitch = fmt::format("{} {} 0", s, c);
  return fmt::format(R"(
      <body name="{0}_hip" pos="0 {1} -0.05" euler="0 0 {2}">
        <joint name="{0}_yaw" axis="0 0 1"/>
        <inertial pos="0 0 0" mass="0.4" diaginertia="0.0004 0.0004 0.0004"/>
        <body name="{0}_thigh" pos="{3}">
          <joint name="{0}_pitch" axis="{4}"/>
          <inertial pos="{5}" mass="1.2" diaginertia="0.01 0.01 0.01"/>
          <body name="{0}_shank" pos="{6}">
            <joint name="{0}_knee" axis="{4}"/>
            <inertial pos="{5}" mass="0.8" diaginertia="0.006 0.006 0.006"/>
            <geom name="{0}_ball" size="0.02" pos="{7}"/>
          </body>
        </body>
      </body>)",
                     side, y, turn + drawn, at(0.03, -0.02), pitch, at(0, -0.1), at(0.01, -0.25),
                     at(0.02, -0.25));
}

}  // namespace

std::string turned_biped(const TurnedBiped& how) {
  std::string servos;
  for (const char* side : {"left", "right"})
    for (const char* joint : {"yaw", "pitch", "knee"})
      servos += fmt::format("<position joint=\"{}_{}\" kp=\"200\" forcerange=\"-80 80\"/>\n    ",
                            side, joint);
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
                     how.waist ? "<body name=\"abdomen\"><joint name=\"waist\" axis=\"0 0 1\"/>"
                                 "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"0.01 0.01 "
                                 "0.01\"/>"
                               : "",
                     leg("left", 0.1, 0.0, 0.0), leg("right", -0.1, how.turn, how.zero),
                     how.waist ? "</body>" : "", servos, how.waist ? "0" : "", kToesOut, kPitch,
                     kKnee, -kToesOut - how.zero, kPitch, kKnee);
}

}  // namespace legwright::test
