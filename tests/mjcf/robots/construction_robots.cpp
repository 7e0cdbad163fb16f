// SPDX-License-Identifier: Apache-2.0
#include "tests/mjcf/robots/construction_robots.hpp"

#include <fmt/format.h>

#include "mjcf/propose/declare.hpp"
#include "mjcf/propose/proposals.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/robots/mjcf_builder.hpp"

namespace legwright::test {
namespace {

std::string biped_leg(const std::string& side, int sign) {
  const auto body = [&](const char* part, const std::string& place = "") {
    return fmt::format("name=\"{}_{}\"{}", side, part, place);
  };
  return chain({
      {body("hip", fmt::format(" pos=\"0 {} -0.05\"", 0.1 * sign)),
       {hinge(side + "_roll", "1 0 0", R"(range="-0.5 0.5")"),
        inertial("0 0 0", 0.4, "0.0004 0.0004 0.0004")}},
      {body("thigh"),
       {hinge(side + "_pitch", "0 1 0", R"(range="-1.5 1.5")"),
        inertial("0 0 -0.15", 1.2, "0.012 0.012 0.001"),
        R"(<geom type="capsule" fromto="0 0 0 0 0 -0.3" size="0.03" class="drawn"/>)"}},
      {body("shank", " pos=\"0 0 -0.3\""),
       {hinge(side + "_knee", "0 1 0", R"(range="0 2.4")"),
        inertial("0 0 -0.15", 0.8, "0.008 0.008 0.0006"),
        R"(<geom type="cylinder" pos="0 0 -0.15" size="0.02 0.15" class="drawn"/>)"}},
      {body("foot", " pos=\"0 0 -0.3\""),
       {hinge(side + "_ankle", "0 1 0", R"(range="-1 1")"),
        R"(<geom type="box" pos="0.03 0 -0.03" size="0.09 0.04 0.01"/>)",
        R"(<geom type="box" pos="-0.03 0 0" size="0.01 0.01 0.01" mass="0.1"/>)"}},
  });
}

std::string biped_servos(const char* side) {
  const auto servos = [&](const char* strength, std::initializer_list<const char*> joints) {
    return for_each_joint(
        fmt::format("\n    <position name=\"{{0}}_{{1}}\" joint=\"{{0}}_{{1}}\" {}/>", strength)
            .c_str(),
        {side}, joints);
  };
  return servos(R"(kp="200" kv="4" forcerange="-80 80")", {"roll", "pitch", "knee"}) +
         servos(R"(kp="100" kv="2" forcerange="-40 40")", {"ankle"});
}

std::string quadruped_leg(const char* name, int front, int left) {
  const std::string side = fmt::format("0 {} 0", 0.08 * left);
  const int rear = front > 0 ? 0 : 1;
  return chain({
      {fmt::format("name=\"{}_hip\" pos=\"{} {} 0\"", name, 0.1881 * front, 0.04675 * left),
       {fmt::format(
            R"(<inertial mass="0.68" pos="{} {} 0" quat="0.507528 0.506268 0.491507 0.494499"
          diaginertia="0.000734064 0.000468438 0.000398719"/>)",
            -0.005 * front, 0.004 * left),
        fmt::format(R"(<joint class="abduction" name="{}_hip_joint"/>)", name),
        fmt::format(R"(<geom class="drawn" mesh="hip" quat="1 0 0 {}"/>)", rear),
        fmt::format(R"(<geom class="collision" type="cylinder" size="0.046 0.02" pos="{}" {}/>)",
                    side, R"(quat="1 1 0 0")")}},
      {fmt::format("name=\"{}_thigh\" pos=\"{}\"", name, side),
       {cad_inertial(1.009, fmt::format("-0.003 {} -0.033", -0.022 * left), "0.0045 0.0044 0.001"),
        fmt::format(R"(<joint class="hip" name="{}_thigh_joint"/>)", name),
        R"(<geom class="drawn" mesh="thigh"/>)",
        R"(<geom class="collision" type="capsule" size="0.015 0.08" pos="0 0 -0.1065"/>)"}},
      {fmt::format("name=\"{}_calf\" pos=\"0 0 -0.213\"", name),
       {cad_inertial(0.1958, "0.0065 0 -0.107", "0.0015 0.0015 3e-05"),
        fmt::format(R"(<joint class="knee" name="{}_calf_joint"/>)", name),
        R"(<geom class="drawn" mesh="calf"/>)",
        fmt::format(R"(<frame pos="0 0 -0.1" euler="0 0 {}">)", rear),
        R"(  <geom class="collision" type="box" size="0.01 0.01 0.06"/>)",
        fmt::format(R"(  <site name="{}_imu" pos="0.01 0 -0.02"/>)", name), "</frame>",
        R"(<geom class="foot"/>)"}},
  });
}

std::string armed_quadruped_leg(const char* name, int front, int left) {
  const auto joint = [&](const char* kind) {
    return fmt::format(R"(<joint class="{0}" name="{1}_{0}"/>)", kind, name);
  };
  return chain({
      {fmt::format("name=\"{}_hip\" pos=\"{} {} 0\"", name, 0.29785 * front, 0.055 * left),
       {cad_inertial(1.7, "0 0 0", "0.002 0.002 0.002"), joint("hx")}},
      {fmt::format("name=\"{}_upper\" pos=\"0 {} 0\"", name, 0.111 * left),
       {cad_inertial(2.3, "0 0 -0.1", "0.02 0.02 0.002"), joint("hy"),
        R"(<geom class="drawn" type="capsule" fromto="0 0 0 0 0 -0.32" size="0.03"/>)"}},
      {fmt::format("name=\"{}_lower\" pos=\"0 0 -0.32\"", name),
       {cad_inertial(0.33, "0 0 -0.15", "0.004 0.004 0.0001"), joint("kn"),
        R"(<geom type="capsule" size="0.02" fromto="0 0 0 0 0 -0.3"/>)",
        fmt::format(R"(<geom class="foot" name="{}"/>)", name)}},
  });
}

}  // namespace

std::string armed_biped() {
  return R"(<mujoco model="armed_biped">
  <compiler angle="radian" autolimits="true"/>
  <default>
    <default class="drawn"><geom contype="0" conaffinity="0" group="2" density="0"/></default>
    <default class="arm"><joint axis="0 1 0" damping="0.1"/><position kp="20"/></default>
  </default>
  <worldbody>
    <body name="pelvis" pos="0 0 0.7">
      <freejoint/>
      <inertial pos="0 0 0.1" mass="8" diaginertia="0.1 0.08 0.05"/>
      <geom type="box" size="0.05 0.08 0.1" pos="0 0 0.1" class="drawn"/>)" +
         biped_leg("left", 1) + biped_leg("right", -1) + R"(
      <frame pos="0.02 0 0.2" euler="0.3 0 0.2">
        <body name="arm" pos="0 0.1 0" euler="0 0.4 0" childclass="arm">
          <joint name="shoulder" pos="0.01 0 0.02"/>
          <inertial pos="0 0 -0.1" mass="0.6" diaginertia="0.003 0.003 0.0005"/>
          <site name="top"/>
          <body name="hand" pos="0 0 -0.25">
            <joint type="ball" axis="1 0 0"/>
            <inertial pos="0.02 0 -0.03" mass="0.2" diaginertia="0.0002 0.0002 0.0002"/>
            <body name="thumb" pos="0.02 0.02 -0.05">
              <joint name="thumb" type="slide" axis="0 1 0" range="-0.02 0.02"/>
              <geom type="box" size="0.005 0.005 0.02" mass="0.03"/>
            </body>
            <body name="finger" pos="0.02 -0.02 -0.05">
              <joint name="finger" type="slide" axis="0 1 0" range="-0.02 0.02"/>
              <geom type="box" size="0.005 0.005 0.02" mass="0.03"/>
              <site name="tip"/>
            </body>
          </body>
        </body>
      </frame>
      <body name="lidar" pos="0 0 0.25">
        <joint axis="0 0 1"/>
        <geom type="cylinder" size="0.03 0.02" mass="0.2"/>
      </body>
    </body>
  </worldbody>
  <tendon>
    <fixed name="grip"><joint joint="thumb" coef="1"/><joint joint="finger" coef="-1"/></fixed>
    <spatial name="sinew" range="0 1"><site site="top"/><site site="tip"/></spatial>
  </tendon>
  <equality><joint name="mirror" joint1="thumb" joint2="finger" polycoef="0 -1 0 0 0"/></equality>
  <actuator>)" +
         biped_servos("left") + R"(
    <position name="shoulder" class="arm" joint="shoulder"/>)" +
         biped_servos("right") + R"(
    <position name="grip" tendon="grip" kp="50"/>
  </actuator>
  <sensor>
    <jointpos name="shoulder_angle" joint="shoulder"/>
    <actuatorfrc name="grip_force" actuator="grip"/>
    <tendonpos name="grip_width" tendon="grip"/>
    <jointpos name="knee_angle" joint="left_knee"/>
  </sensor>
  <keyframe>
    <key name="home" qpos="0 0 0.69 1 0 0 0  0 -0.3 0.6 -0.3  0 -0.3 0.6 -0.3
      0.7 0.9 0.1 0.2 0.3 0.01 -0.01  0.5"/>
  </keyframe>
  <custom>)" +
         declarations({
             {"thigh", "0.3 0.2 0.4", "m | stretch link: left_thigh right_thigh | Thighs."},
             {"shank", "0.3 0.2 0.4", "m | stretch link: left_shank right_shank | Shanks."},
             {"width", "0.2 0.16 0.3", "m | stretch y: pelvis | Distance of the hips."},
             {"knee_yaw", "0 -0.5 0.5", "rad | axis z: left_knee ~right_knee | Yaw of knees."},
             {"sole", "0.03 0.02 0.05",
              "m | stretch x: left_foot right_foot | From ankle to sole."},
         }) +
         R"(
  </custom>
</mujoco>
)";
}

std::string classed_quadruped() {
  std::string motors;
  for (const char* leg : {"FR", "FL", "RR", "RL"})
    motors += fmt::format(R"(
    <motor class="abduction" name="{0}_hip" joint="{0}_hip_joint"/>
    <motor class="hip" name="{0}_thigh" joint="{0}_thigh_joint"/>
    <motor class="knee" name="{0}_calf" joint="{0}_calf_joint"/>)",
                          leg);
  return R"(<mujoco model="classed_quadruped">
  <compiler angle="radian" autolimits="true"/>
  <option cone="elliptic" impratio="100"/>
  <default>
    <default class="quadruped">
      <geom friction="0.6" margin="0.001" condim="1"/>
      <joint axis="0 1 0" armature="0.01" frictionloss="0.02"/>
      <motor ctrlrange="-23.7 23.7"/>
      <default class="abduction"><joint axis="1 0 0" range="-0.863 0.863"/></default>
      <default class="hip"><joint range="-0.686 4.501"/></default>
      <default class="knee"><joint range="-2.818 -0.888"/><motor ctrlrange="-35.55 35.55"/></default>
      <default class="drawn">
        <geom type="mesh" contype="0" conaffinity="0" group="2" density="0"/>
      </default>
      <default class="collision">
        <geom group="3" type="capsule"/>
        <default class="foot">
          <geom type="sphere" size="0.023" pos="0 0 -0.213" priority="1" condim="6"
            friction="0.8 0.02 0.01"/>
        </default>
      </default>
    </default>
  </default>
  <asset>
    <mesh name="trunk" vertex=")" +
         box_vertices(0.2, 0.05, -0.05, 0.05) + R"("/>
    <mesh name="hip" vertex=")" +
         box_vertices(0.03, 0.03, -0.03, 0.03) + R"("/>
    <mesh name="thigh" scale="1 1 0.5" vertex=")" +
         box_vertices(0.02, 0.02, -0.426, 0) + R"("/>
    <mesh name="calf" vertex=")" +
         box_vertices(0.01, 0.01, -0.213, 0) + R"("/>
  </asset>
  <worldbody>
    <body name="trunk" pos="0 0 0.445" childclass="quadruped">
      <freejoint/>
      <inertial mass="5.204" pos="0.0223 0.002 -0.0005" quat="-0.00342088 0.705204 0.000106698 0.708996"
        diaginertia="0.0716565 0.0630105 0.0168101"/>
      <geom class="drawn" mesh="trunk"/>
      <geom class="collision" type="box" size="0.125 0.04 0.057"/>
      <site name="imu" pos="-0.01592 -0.06659 -0.00617"/>)" +
         quadruped_leg("FR", 1, -1) + quadruped_leg("FL", 1, 1) + quadruped_leg("RR", -1, -1) +
         quadruped_leg("RL", -1, 1) + R"(
    </body>
  </worldbody>
  <actuator>)" +
         motors + R"(
  </actuator>
  <keyframe>
    <key name="home" qpos="0 0 0.27 1 0 0 0 0 0.9 -1.8 0 0.9 -1.8 0 0.9 -1.8 0 0.9 -1.8"/>
  </keyframe>
</mujoco>
)";
}

std::string quadruped_with_arm() {
  std::string servos =
      for_each_joint("\n    <position class=\"{1}\" name=\"{0}_{1}\" joint=\"{0}_{1}\"/>",
                     {"fl", "fr", "hl", "hr"}, {"hx", "hy", "kn"});
  std::string arm, ends;
  const char* const joints[] = {"arm_sh0", "arm_sh1", "arm_el0", "arm_el1", "arm_wr0", "arm_wr1"};
  for (int k = 0; k < 6; ++k) {
    arm += fmt::format(R"(
      <body name="{0}" pos="{1} 0 {2}">
        <inertial mass="1.1" pos="0.05 0 0" diaginertia="0.002 0.003 0.003"/>
        <joint name="{0}" axis="{3}" range="-3.2 3.2"/>
        <geom type="capsule" size="0.03" fromto="0 0 0 0.1 0 0"/>)",
                       joints[k], k == 0 ? 0.292 : 0.12, k == 0 ? 0.188 : 0.0,
                       k == 0 || k == 3 || k == 5 ? "0 0 1" : "0 1 0");
    ends += "</body>";
    servos += fmt::format(
        "\n    <position name=\"{0}\" joint=\"{0}\" kp=\"100\" kv=\"3\" "
        "inheritrange=\"1\"/>",
        joints[k]);
  }
  return R"(<mujoco model="quadruped_with_arm">
  <compiler angle="radian" autolimits="true"/>
  <default>
    <default class="legs">
      <joint damping="2" armature="0.01"/>
      <geom condim="1" group="3"/>
      <position kp="500" kv="20" inheritrange="1" forcerange="-1000 1000"/>
      <default class="hx"><joint axis="1 0 0" range="-0.785 0.785" actuatorfrcrange="-45 45"/></default>
      <default class="hy"><joint axis="0 1 0" range="-0.9 2.3" actuatorfrcrange="-45 45"/></default>
      <default class="kn"><joint axis="0 1 0" range="-2.79 -0.25" actuatorfrcrange="-115 115"/></default>
      <default class="drawn"><geom contype="0" conaffinity="0" group="2"/></default>
      <default class="foot"><geom type="sphere" size="0.036" pos="0 0 -0.336" priority="1"/></default>
    </default>
  </default>
  <worldbody>
    <body name="body" pos="0 0 0.7" childclass="legs">
      <freejoint/>
      <inertial mass="16.7" pos="0 0 0" diaginertia="0.08 0.3 0.35"/>
      <geom type="box" size="0.4 0.1 0.08"/>)" +
         armed_quadruped_leg("fl", 1, 1) + armed_quadruped_leg("fr", 1, -1) +
         armed_quadruped_leg("hl", -1, 1) + armed_quadruped_leg("hr", -1, -1) + arm + ends + R"(
    </body>
  </worldbody>
  <contact><exclude body1="body" body2="arm_sh0"/><exclude body1="arm_sh0" body2="arm_el0"/></contact>
  <actuator>)" +
         servos + R"(
  </actuator>
  <keyframe>
    <key name="home" qpos="0 0 0.46 1 0 0 0 0 1.04 -1.8 0 1.04 -1.8 0 1.04 -1.8 0 1.04 -1.8
      0 -3.14 3.06 0 0 0"
      ctrl="0 1.04 -1.8 0 1.04 -1.8 0 1.04 -1.8 0 1.04 -1.8 0 -3.14 3.06 0 0 0"/>
  </keyframe>
</mujoco>
)";
}

std::string hopper_with(const std::string& foot, double knee, bool weighed_by_foot) {
  return fmt::format(R"(<mujoco model="hopper">
  <compiler angle="radian" autolimits="true"/>
  <asset>
    <mesh name="shoe" vertex="-0.05 -0.02 0  0.07 -0.02 0  -0.05 0.02 0  0.07 0.02 0
      -0.01 0 0.06  0.01 0 0.06"/>
  </asset>
  <worldbody>
    <body name="trunk" pos="0 0 0.5">
      <freejoint/>
      <inertial pos="0 0 0" mass="1" diaginertia="0.001 0.001 0.001"/>
      <body name="thigh">
        <joint name="hip" axis="0 1 0"/>
        <inertial pos="0 0 -0.1" mass="0.1" diaginertia="1e-4 1e-4 1e-5"/>
        <body name="shank" pos="0 0 -0.2">
          <joint name="knee" axis="0 1 0"/>
          {}
          {}
        </body>
      </body>
    </body>
  </worldbody>
  <actuator>
    <position name="hip_servo" joint="hip" kp="80" kv="0.8" forcerange="-3 3"/>
    <position name="knee_servo" joint="knee" kp="80" kv="0.8" forcerange="-3 3"/>
  </actuator>
  <keyframe><key name="home" qpos="0 0 0.5 1 0 0 0 0 {}"/></keyframe>
</mujoco>
)",
                     weighed_by_foot
                         ? ""
                         : R"(<inertial pos="0 0 -0.1" mass="0.1" diaginertia="1e-4 1e-4 1e-5"/>)",
                     foot, knee);
}

std::string declared(const std::string& xml) {
  return with_declarations(xml, "robot.xml", propose_parameters(xml, "robot.xml").proposals);
}

std::string error_message(const std::string& xml) {
  try {
    parse_robot(xml, "robot.xml");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace legwright::test
