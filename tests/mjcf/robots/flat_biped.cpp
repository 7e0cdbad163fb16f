// SPDX-License-Identifier: Apache-2.0
#include "tests/mjcf/robots/flat_biped.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "tests/mjcf/robots/mjcf_builder.hpp"

namespace legwright::test {
namespace {

constexpr double kBend = 0.3;       // at home [rad]
constexpr double kPelvis = 0.5777;  // its height at home: 0.05 + 0.5 cos 0.3 + 0.05 [m]

std::string of_side(std::string text, const std::string& side) {
  for (std::size_t at = 0; (at = text.find("SIDE", at)) != std::string::npos;)
    text.replace(at, 4, side);
  return text;
}

std::string flat_footed_leg(const FlatBiped& how, const std::string& side, double y) {
  const auto body = [&](const char* part, const std::string& place = "") {
    return fmt::format("name=\"{}_{}\"{}", side, part, place);
  };
  return chain({
      {body("hip", fmt::format(" pos=\"0 {} -0.05\"", y)),
       {hinge(side + "_yaw", "0 0 1"), inertial("0 0 0", 0.5, "0.0005 0.0005 0.0005")}},
      {body("pelvis"),
       {hinge(side + "_roll", "1 0 0"), inertial("0 0 0", 0.5, "0.0005 0.0005 0.0005")}},
      {body("thigh"),
       {hinge(side + "_pitch", "0 1 0"), inertial("0 0 -0.12", 2, "0.012 0.012 0.002")}},
      {body("shank", " pos=\"0 0 -0.25\""),
       {hinge(side + "_knee", "0 1 0"), inertial("0 0 -0.12", 1.5, "0.009 0.009 0.001")}},
      {body("ankle", " pos=\"0 0 -0.25\""),
       {hinge(side + "_ankle_pitch", "0 1 0"), inertial("0 0 0", 0.3, "0.0002 0.0002 0.0002")}},
      {body("foot"),
       {how.ankle_roll ? hinge(side + "_ankle_roll", "1 0 0") : "",
        inertial("0.02 0 -0.03", 0.4, "0.0004 0.001 0.001"), of_side(how.foot, side)}},
  });
}

}  // namespace

std::string flat_biped(const FlatBiped& how) {
  std::string servos, angles;
  for (const char* side : {"left", "right"}) {
    for (const char* joint : {"yaw", "roll", "pitch", "knee", "ankle_pitch", "ankle_roll"}) {
      const bool ankle = std::string(joint).rfind("ankle", 0) == 0;
      if (joint == std::string("ankle_roll") && !how.ankle_roll) continue;
      servos += fmt::format(
          "    <position joint=\"{0}_{1}\" kp=\"{2}\" kv=\"{3}\" forcerange=\"-{4} {4}\"/>\n", side,
          joint, how.kp, how.kd, ankle ? how.limit : 200.0);
    }
    angles += fmt::format(" 0 0 {} {} {}{}", -kBend, 2 * kBend, -kBend, how.ankle_roll ? " 0" : "");
  }
  return fmt::format(R"(<mujoco model="flat_biped">
  <compiler angle="radian"/>
  <custom>{0}</custom>
  <worldbody>
    <body name="pelvis" pos="0 0 {1}">
      <freejoint/>
      <inertial pos="0.02 0 0.1" mass="8" diaginertia="0.1 0.08 0.05"/>{2}{3}
    </body>
  </worldbody>
  <actuator>
{4}  </actuator>
  <keyframe>
    <key name="home" qpos="0 0 {1} 1 0 0 0{5}"/>
  </keyframe>
</mujoco>
)",
                     how.custom, kPelvis, flat_footed_leg(how, "left", 0.09),
                     flat_footed_leg(how, "right", -0.09), servos, angles);
}

const std::vector<NamedFoot>& flat_feet() {
  static const std::vector<NamedFoot> feet{
      {"box", R"(<geom type="box" size="0.08 0.04 0.01" pos="0.02 0 -0.04"/>)"},
      {"four_balls",
       R"(<geom size="0.01" pos="0.1 0.04 -0.04"/><geom size="0.01" pos="0.1 -0.04 -0.04"/>
        <geom size="0.01" pos="-0.06 0.04 -0.04"/><geom size="0.01" pos="-0.06 -0.04 -0.04"/>)"},
      {"disc", R"(<geom type="cylinder" size="0.05 0.01" pos="0.01 0 -0.04"/>)"},
      {"three_bars", R"(<geom type="capsule" size="0.01" fromto="-0.05 0.03 -0.04 0.09 0.03 -0.04"/>
        <geom type="capsule" size="0.01" fromto="-0.05 0 -0.04 0.09 0 -0.04"/>
        <geom type="capsule" size="0.01" fromto="-0.05 -0.03 -0.04 0.09 -0.03 -0.04"/>)"},
      {"toe_bar_and_heel",
       R"(<geom type="capsule" size="0.01" fromto="0.09 -0.04 -0.04 0.09 0.04 -0.04"/>
        <geom size="0.01" pos="-0.05 0 -0.04"/>)"},
      {"box_and_ball", R"(<geom type="box" size="0.03 0.04 0.01" pos="0.07 0 -0.04"/>
        <geom size="0.01" pos="-0.05 0 -0.04"/>)"}};
  return feet;
}

const std::vector<NamedFoot>& pointed_feet() {
  static const std::vector<NamedFoot> feet{
      {"ball", R"(<geom size="0.02" pos="0 0 -0.03"/>)"},
      {"bar", R"(<geom type="capsule" size="0.01" fromto="-0.05 0 -0.04 0.09 0 -0.04"/>)"},
      {"two_balls",
       R"(<geom size="0.01" pos="0.08 0 -0.04"/><geom size="0.01" pos="-0.05 0 -0.04"/>)"},
      {"blade", R"(<geom type="box" size="0.08 0.008 0.02" pos="0.02 0 -0.03"/>)"},
      {"ball_and_high_box", R"(<geom size="0.02" pos="0 0 -0.03"/>
        <geom type="box" size="0.06 0.04 0.005" pos="0 0 -0.02"/>)"}};
  return feet;
}

const char* foot_geoms(const std::string& name) {
  for (const auto* feet : {&flat_feet(), &pointed_feet()})
    for (const NamedFoot& foot : *feet)
      if (foot.name == name) return foot.geoms;
  throw std::invalid_argument("no foot " + name);
}

}  // namespace legwright::test
