// SPDX-License-Identifier: Apache-2.0
// A URDF of one leg, with what URDFs of robots have: links without mass, a link fixed in between.
#pragma once

#include <string>
#include <vector>

#include "mjcf/urdf/read_urdf.hpp"

namespace legwright::test {

inline bool tells(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline std::string joined(const std::vector<std::string>& notes) {
  std::string out;
  for (const std::string& note : notes) out += note + "\n";
  return out;
}

inline const char* const kHead = R"(<?xml version="1.0"?>
<!-- a <robot> in a comment -->
<robot name="hopper">
  <material name="red"><color rgba="0.8 0.1 0.1 1"/></material>
  <link name="mount"/>
  <joint name="rest" type="fixed"><parent link="mount"/><child link="trunk"/></joint>
  <link name="trunk">
    <inertial><origin xyz="0 0 0.01" rpy="0 0 0.5"/><mass value="2"/>
      <inertia ixx="0.01" ixy="0.001" ixz="0" iyy="0.02" iyz="0" izz="0.025"/></inertial>
    <visual><geometry><box size="0.2 0.1 0.04"/></geometry><material name="red"/></visual>
    <collision name="shell"><geometry><box size="0.2 0.1 0.04"/></geometry></collision>
  </link>
)";
inline const char* const kLeg = R"(
  <link name="thigh">
    <inertial><origin xyz="0 0 -0.05"/><mass value="0.3"/>
      <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.0001"/></inertial>
  </link>
  <joint name="hip" type="revolute"><origin xyz="0 0 -0.02" rpy="0 0.1 0"/>
    <parent link="trunk"/><child link="thigh"/><axis xyz="0 1 0"/>
    <limit lower="-1.5" upper="1.5" effort="6" velocity="20"/><dynamics damping="0.1" friction="0.02"/>
  </joint>
  <link name="thigh_plate"/>
  <joint name="plate" type="fixed"><parent link="thigh"/><child link="thigh_plate"/></joint>
  <link name="shank">
    <inertial><origin xyz="0 0 -0.05"/><mass value="0.2"/>
      <inertia ixx="0.0008" ixy="0" ixz="0" iyy="0.0008" iyz="0" izz="0.00005"/></inertial>
  </link>
  <joint name="knee" type="continuous"><origin xyz="0.01 0 -0.12"/>
    <parent link="thigh_plate"/><child link="shank"/><axis xyz="0 1 0"/>
    <limit effort="4" velocity="20"/></joint>
  <link name="toe"><collision><geometry><sphere radius="0.02"/></geometry></collision></link>
  <joint name="tip" type="fixed"><origin xyz="0 0 -0.13"/><parent link="shank"/><child link="toe"/></joint>
)";
inline const std::string kHopper = std::string(kHead) + kLeg + "</robot>";

inline MjcfOfUrdf made(const std::string& urdf, const std::string& file = "hopper.urdf") {
  return mjcf_of_urdf(urdf, file);
}

}  // namespace legwright::test
