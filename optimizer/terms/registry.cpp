// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/registry.hpp"

#include "optimizer/terms/factories.hpp"

namespace legwright {

const std::vector<TermEntry>& term_registry() {
  static const std::vector<TermEntry> table{
      // Objectives.
      {"travel", "(9)", 1e3, make_travel},
      {"turning", "(9)", 1e3, make_turning},
      {"style_com", "(10)", 20.0, make_style_com},
      {"style_foot", "(10)", 0.3, make_style_foot},
      {"trunk_orientation", "(10)", 30.0, make_trunk_orientation},
      {"nominal_pose", "-", 1e-2, make_nominal_pose},
      {"smoothness", "(11)", 0.3, make_smoothness},
      // Constraints.
      {"com_position", "(12)", 1e5, make_com_position},
      {"foot_position", "(12)", 1e4, make_foot_position},
      {"force_balance", "(13)", 1e3, make_force_balance},
      {"torque_balance", "(13)", 1e3, make_torque_balance},
      {"stance_foot", "(14)", 1e4, make_stance_foot},
      {"friction_cone", "(15)", 1e-3, make_friction_cone},
      {"limb_clearance", "(16)", 1e-3, make_limb_clearance},
      {"periodicity", "(17)", 1e4, make_periodicity},
      {"ground_height", "-", 1e4, make_ground_height},
      {"swing_height", "-", 1e3, make_swing_height},
      {"least_normal_force", "-", 1e-3, make_least_normal_force},
      {"joint_limits", "-", 1e-3, make_joint_limits},
      {"torque_limits", "-", 1e-3, make_torque_limits},
      {"stroke_limits", "-", 1e-3, make_stroke_limits},
      {"actuator_force", "-", 1e-3, make_actuator_force},
      // Regularisers.
      {"force_size", "-", 1e-3, make_force_size},
      {"force_smoothness", "-", 0.05, make_force_smoothness},
      {"design_tether", "-", 0.05, make_design_tether},
      // Outer objectives: no part of F unless a task gives them a weight.
      {"mechanical_work", "-", 0.0, make_mechanical_work},
      {"peak_torque", "-", 0.0, make_peak_torque},
      {"printed_volume", "-", 0.0, make_printed_volume},
  };
  return table;
}

}  // namespace legwright
