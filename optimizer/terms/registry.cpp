// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/registry.hpp"

#include "optimizer/terms/factories.hpp"

namespace legwright {

const std::vector<TermEntry>& term_registry() {
  static const std::vector<TermEntry> table{
      // Objectives.
      {"travel", "(9)", 1e3, make_travel, TermRole::objective, "m", "distance per cycle",
       "distance missed"},
      {"turning", "(9)", 1e3, make_turning, TermRole::objective, "rad", "turn per cycle",
       "turn missed"},
      {"style_com", "(10)", 20.0, make_style_com, TermRole::objective, "m",
       "body where it should be", "body off its place"},
      {"style_foot", "(10)", 0.3, make_style_foot, TermRole::objective, "m",
       "feet where they should be", "feet off their place"},
      {"style_foot_height", "(10)", 20.0, make_style_foot_height, TermRole::objective, "m",
       "feet as high as they should be", "feet off their wanted height"},
      {"style_joint", "(10)", 20.0, make_style_joint, TermRole::objective, "rad",
       "joints at their wanted angles", "joints off their wanted angles"},
      {"trunk_orientation", "(10)", 30.0, make_trunk_orientation, TermRole::objective, "rad",
       "trunk stays level", "tilt of the trunk"},
      {"nominal_pose", "-", 1e-2, make_nominal_pose, TermRole::objective, "rad",
       "near the home pose", "distance from the home pose"},
      {"smoothness", "(11)", 0.3, make_smoothness, TermRole::objective, "rad", "smooth joints",
       "jerky joints"},
      // Constraints.
      {"com_position", "(12)", 1e5, make_com_position, TermRole::constraint, "m",
       "centre of mass fits the pose", "centre of mass off the body's"},
      {"foot_position", "(12)", 1e4, make_foot_position, TermRole::constraint, "m",
       "feet fit the pose", "feet off the legs' ends"},
      {"force_balance", "(13)", 1e3, make_force_balance, TermRole::constraint, "N",
       "forces carry the body", "forces out of balance"},
      {"torque_balance", "(13)", 1e3, make_torque_balance, TermRole::constraint, "N m",
       "forces turn the body", "torques out of balance"},
      {"stance_foot", "(14)", 1e4, make_stance_foot, TermRole::constraint, "m",
       "stance feet do not slip", "slip of stance feet"},
      {"friction_cone", "(15)", 1e-3, make_friction_cone, TermRole::constraint, "N",
       "forces inside friction cone", "closeness to the friction limit"},
      {"limb_clearance", "(16)", 1e-3, make_limb_clearance, TermRole::constraint, "m",
       "limbs keep apart", "closeness of limbs"},
      {"periodicity", "(17)", 1e4, make_periodicity, TermRole::constraint, "m, rad, N",
       "cycle closes", "gap where the cycle closes"},
      {"ground_height", "-", 1e4, make_ground_height, TermRole::constraint, "m",
       "stance feet on the ground", "stance feet off the ground"},
      {"swing_height", "-", 1e3, make_swing_height, TermRole::constraint, "m",
       "swing feet clear the ground", "swing feet off their height"},
      {"flat_foot", "-", 1e4, make_flat_foot, TermRole::constraint, "rad", "flat feet lie level",
       "tilt and turn of flat feet"},
      {"least_normal_force", "-", 1e-3, make_least_normal_force, TermRole::constraint, "N",
       "stance feet bear weight", "stance feet without load"},
      {"joint_limits", "-", 1e-3, make_joint_limits, TermRole::constraint, "rad",
       "joints within their range", "closeness to joint limits"},
      {"torque_limits", "-", 1e-3, make_torque_limits, TermRole::constraint, "N m",
       "torques within limits", "closeness to torque limits"},
      {"stroke_limits", "-", 1e-3, make_stroke_limits, TermRole::constraint, "m",
       "linear actuators within their stroke", "closeness to the ends of the stroke"},
      {"actuator_force", "-", 1e-3, make_actuator_force, TermRole::constraint, "N m",
       "linear actuators within their force", "closeness to force limits of actuators"},
      // Regularisers.
      {"force_size", "-", 1e-3, make_force_size, TermRole::regulariser, "N", "small forces",
       "large forces"},
      {"force_smoothness", "-", 0.05, make_force_smoothness, TermRole::regulariser, "N",
       "smooth forces", "jerky forces"},
      {"design_tether", "-", 0.05, make_design_tether, TermRole::regulariser, "1",
       "near the initial design", "distance from the initial body"},
      // Outer objectives: no part of F unless a task gives them a weight.
      {"mechanical_work", "-", 0.0, make_mechanical_work, TermRole::outer, "J",
       "work of the motors", "work of the motors"},
      {"peak_torque", "-", 0.0, make_peak_torque, TermRole::outer, "N m", "highest torque",
       "highest torque", kPeakNorm},
      {"printed_volume", "-", 0.0, make_printed_volume, TermRole::outer, "m^3", "volume to print",
       "printed volume"},
  };
  return table;
}

const TermEntry* find_term(std::string_view name) {
  for (const TermEntry& entry : term_registry())
    if (entry.name == name) return &entry;
  return nullptr;
}

}  // namespace legwright
