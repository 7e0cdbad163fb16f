// SPDX-License-Identifier: Apache-2.0
#include "tests/tools/simulate/tiny_scene.hpp"

#include <fmt/format.h>

#include "plugin/trajectory.hpp"

namespace legwright {

std::string TinyScene::xml() const {
  Trajectory plan = blank_trajectory({"tail"}, {"FL", "FR", "HL", "HR"}, 8, kPeriod);
  for (int knot = 0; knot < plan.knot_count; ++knot) {
    plan.at(knot, plan.target_column(0)) = wag * (knot < 4 ? 1 : -1);
    for (int foot = 0; foot < plan.foot_count(); ++foot) {
      plan.at(knot, plan.contact_column(foot)) = foot == 0 && swinging_foot && knot >= 4 ? 0 : 1;
    }
  }
  std::string feet;
  for (const auto& [name, x, y] :
       {std::tuple{"FL", 0.1, 0.1}, {"FR", 0.1, -0.1}, {"HL", -0.1, 0.1}, {"HR", -0.1, -0.1}}) {
    feet += fmt::format(
        "<geom name='{}' type='sphere' size='0.02' pos='{} {} -0.08' friction='{} 0.005 "
        "0.0001'/>\n",
        name, x, y, friction);
  }
  return fmt::format(R"(<mujoco model="table">
  <extension><plugin plugin="legwright.gait"><instance name="gait">
    <config key="kp" value="2"/><config key="kd" value="0.05"/><config key="trajectory" value="{}"/>
  </instance></plugin></extension>
  <compiler angle="radian" autolimits="true"/>
  <option integrator="implicitfast" timestep="{}" cone="elliptic"/>
  <default><default class="pd"><general biastype="affine" biasprm="0 -2 -0.05"/></default></default>
  <worldbody>
    <geom name="floor" type="plane" size="10 10 0.1" friction="{} 0.005 0.0001" solref="0.005 1"/>
    <body name="trunk" pos="0 0 0.1">
      <freejoint name="root"/>
      <inertial pos="0 0 0" mass="1" diaginertia="0.005 0.005 0.005"/>
      <geom type="box" size="0.1 0.1 0.02"/>
      {}
      <body name="tail" pos="-0.1 0 0">
        <joint name="tail" axis="0 0 1" armature="0.001"/>
        <geom type="capsule" fromto="0 0 0 -0.05 0 0" size="0.005"
              mass="0.01" contype="0" conaffinity="0"/>
      </body>
    </body>
  </worldbody>
  <actuator>
    <plugin name="tail" class="pd" plugin="legwright.gait" instance="gait"
            joint="tail" forcerange="-{} {}"/>
  </actuator>
  <keyframe><key name="gait" qpos="{}" qvel="{}"/></keyframe>
</mujoco>
)",
                     write_trajectory(plan), kTimeStep, friction, feet, torque_limit, torque_limit,
                     start_qpos, start_qvel);
}

}  // namespace legwright
