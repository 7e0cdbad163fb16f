// SPDX-License-Identifier: Apache-2.0
#include "tests/plugin/walker.hpp"

#include <fmt/format.h>

#include "tests/plugin/toy_trajectory.hpp"

namespace legwright {

std::string walker(const WalkerOptions& o) {
  return fmt::format(R"(<mujoco>
  <extension>
    <plugin plugin="legwright.sensor"/>
    <plugin plugin="legwright.gait"><instance name="gait">
      <config key="kp" value="4"/><config key="kd" value="0.1"/>
      <config key="trajectory" value="{}"/>{}
    </instance></plugin>
  </extension>
  <compiler angle="radian" autolimits="true"/>
  <option integrator="implicitfast" timestep="0.001"/>
  <size memory="500K"/>
  <default><default class="pd"><general biastype="affine" biasprm="0 -4 -0.1"/></default></default>
  <worldbody>
    <geom name="floor" type="plane" size="2 2 0.1"/>{}
    <body name="trunk" pos="0 0 0.22">{}
      <geom type="box" size="0.1 0.06 0.03" mass="1"/>
      <body name="leg_a" pos="0.08 0 0"><joint name="a" axis="0 1 0"/>
        <geom type="capsule" size="0.01" fromto="0 0 -0.04 0 0 -0.18" mass="0.1"/>{}
      </body>
      <body name="leg_b" pos="-0.08 0 0"><joint name="b" axis="0 1 0"/>
        <geom type="capsule" size="0.01" fromto="0 0 -0.04 0 0 -0.18" mass="0.1"/>
        <geom name="B" size="0.02" pos="0 0 -0.2"/>
      </body>
    </body>
  </worldbody>
  <actuator>
    <plugin name="drive_a" class="pd" plugin="legwright.gait" instance="gait" joint="a" {}/>
    <plugin name="drive_b" class="pd" plugin="legwright.gait" instance="gait" joint="b"/>
  </actuator>
  <sensor>{}</sensor>
</mujoco>)",
                     write_trajectory(walker_trajectory()), o.config, o.world, o.trunk_joint,
                     o.foot_a, o.actuator_a, o.sensors);
}

Trajectory walker_trajectory() {
  Trajectory t = toy_trajectory(2, 2, 8, 0.8, 5, 0.3);
  for (int knot = 0; knot < t.knot_count; ++knot)  // forces worth an arrow
    for (int foot = 0; foot < 2; ++foot)
      for (int axis = 0; axis < 3; ++axis) t.at(knot, t.force_column(foot, axis)) *= 40.0;
  t.travel = {0.1, 0.02, 0.0};
  t.turn = 0.3;
  return t;
}

std::string gait_sensor(const std::string& kind, const std::string& more_config) {
  return fmt::format(
      R"(<plugin name="{0}" plugin="legwright.sensor"><config key="kind" value="{0}"/>{1}</plugin>)",
      kind, more_config);
}

}  // namespace legwright
