// SPDX-License-Identifier: Apache-2.0
#include "tests/mjcf/robots/mesh_quadruped.hpp"

#include <fmt/format.h>

#include "tests/mjcf/robots/mjcf_builder.hpp"

namespace legwright::test {
namespace {

/// Corners of a box, the lower half as wide as the upper [mm].
std::string bar(double wide, double deep, double bottom, double top) {
  std::string text;
  for (const double z : {bottom, top})
    for (const double y : {-deep, deep})
      for (const double x : {-wide, wide})
        text += fmt::format("{}{} {} {}", text.empty() ? "" : "  ", z == bottom ? x / 2 : x, y, z);
  return text;
}

std::string mesh_leg(const char* name, int front, int left) {
  const auto joint = [&](const char* kind, const char* axis) {
    return fmt::format(R"(<joint class="{}" name="{}_{}"/>)", kind, name, axis);
  };
  return chain({
      {fmt::format("name=\"{}_hip\" pos=\"{} {} 0\"", name, 0.19 * front, 0.05 * left),
       {cad_inertial(0.5, "0 0 0", "0.0006 0.0006 0.0005"), joint("abduction", "hx")}},
      {fmt::format("name=\"{}_thigh\" pos=\"0 {} 0\"", name, 0.08 * left),
       {cad_inertial(0.9, "0 0 -0.05", "0.004 0.004 0.0009"), joint("hip", "hy"),
        fmt::format(R"(<geom class="drawn" mesh="{}"/>)", left > 0 ? "upper" : "upper_mirrored")}},
      {fmt::format("name=\"{}_shank\" pos=\"0 0 -0.21\"", name),
       {cad_inertial(0.2, "0.01 0 -0.1", "0.0012 0.0012 3e-05"), joint("knee", "kn"),
        R"(<geom class="shank" quat="0.970142500145332 0 0.24253562503633297 0"/>)",
        fmt::format(R"(<geom name="{}_paw" class="paw"/>)", name),
        R"(<geom class="drawn" mesh="paw" pos="-0.09 0 -0.18" euler="0 0.2 0"/>)"}},
  });
}

}  // namespace

std::string mesh_quadruped() {
  const std::string servos = for_each_joint(
      "\n    <position name=\"{0}_{1}\" joint=\"{0}_{1}\" kp=\"100\" kv=\"1\""
      " forcerange=\"-25 25\"/>",
      {"fl", "fr", "hl", "hr"}, {"hx", "hy", "kn"});
  return R"(<mujoco model="mesh_quadruped">
  <compiler angle="radian" autolimits="true"/>
  <default>
    <default class="legs">
      <joint axis="0 1 0" armature="0.01" damping="0.1"/>
      <mesh scale="0.001 0.001 0.001"/>
      <default class="abduction"><joint axis="1 0 0" range="-0.8 0.8"/></default>
      <default class="hip"><joint range="-1.5 3"/></default>
      <default class="knee"><joint range="-2.7 -0.2"/></default>
      <default class="drawn">
        <geom type="mesh" contype="0" conaffinity="0" group="2"/>
        <default class="shank"><geom mesh="lower" rgba="0.2 0.4 0.7 1"/></default>
      </default>
      <default class="paw">
        <geom type="mesh" mesh="paw" pos="-0.09 0 -0.18" euler="0 0.2 0" friction="0.8"/>
      </default>
    </default>
  </default>
  <asset>
    <mesh name="frame" vertex=")" +
         bar(0.21, 0.05, -0.04, 0.04) + R"("/>
    <mesh name="upper" class="legs" vertex=")" +
         bar(20, 15, -210, 20) + R"("/>
    <mesh name="upper_mirrored" class="legs" scale="0.001 -0.001 0.001"
      vertex=")" +
         bar(20, 15, -210, 20) + R"("/>
    <mesh class="legs" name="lower" vertex=")" +
         bar(14, 10, -205, 14) + R"("/><mesh class="legs" name="paw" refpos="0 0 5"
      vertex=")" +
         bar(16, 12, -15, 20) + R"("></mesh>
    <mesh name="paw_2" vertex=")" +
         bar(0.01, 0.01, -0.01, 0.01) + R"("/>
  </asset>
  <worldbody>
    <body name="trunk" pos="0 0 0.4" childclass="legs">
      <freejoint/>
      <inertial mass="6" pos="0 0 0" diaginertia="0.02 0.07 0.08"/>
      <geom class="drawn" mesh="frame"/>
      <geom class="drawn" mesh="paw_2" pos="0.2 0 0.04"/>
      <camera name="outside" mode="trackcom" pos="0.3 -1.2 0.5"/>
      <camera name="eye" pos="0.2 0 0.05"/>
      <light name="sun" mode="targetbody" target="trunk" pos="0.1 0 2"/>)" +
         mesh_leg("fl", 1, 1) + mesh_leg("fr", 1, -1) + mesh_leg("hl", -1, 1) +
         mesh_leg("hr", -1, -1) + R"(
    </body>
  </worldbody>
  <actuator>)" +
         servos + R"(
  </actuator>
  <keyframe>
    <key name="home" qpos="0 0 0.3 1 0 0 0  0 0.8 -2.1  0 0.8 -2.1  0 0.8 -2.1  0 0.8 -2.1"/>
  </keyframe>
</mujoco>
)";
}

}  // namespace legwright::test
