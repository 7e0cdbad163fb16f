// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/registry.hpp"

#include "optimizer/terms/factories.hpp"

namespace legwright {

const std::vector<TermEntry>& term_registry() {
  static const std::vector<TermEntry> table{
      // Objectives.
      {"travel", "(9)", 1e3, make_travel, TermRole::objective},
      {"turning", "(9)", 1e3, make_turning, TermRole::objective},
      {"style_com", "(10)", 20.0, make_style_com, TermRole::objective},
      {"style_foot", "(10)", 0.3, make_style_foot, TermRole::objective},
      {"trunk_orientation", "(10)", 30.0, make_trunk_orientation, TermRole::objective},
      {"nominal_pose", "-", 1e-2, make_nominal_pose, TermRole::objective},
      {"smoothness", "(11)", 0.3, make_smoothness, TermRole::objective},
      // Constraints.
      {"com_position", "(12)", 1e5, make_com_position, TermRole::constraint},
      {"foot_position", "(12)", 1e4, make_foot_position, TermRole::constraint},
      {"force_balance", "(13)", 1e3, make_force_balance, TermRole::constraint},
      {"torque_balance", "(13)", 1e3, make_torque_balance, TermRole::constraint},
      {"stance_foot", "(14)", 1e4, make_stance_foot, TermRole::constraint},
      {"friction_cone", "(15)", 1e-3, make_friction_cone, TermRole::constraint},
      {"limb_clearance", "(16)", 1e-3, make_limb_clearance, TermRole::constraint},
      {"periodicity", "(17)", 1e4, make_periodicity, TermRole::constraint},
      {"ground_height", "-", 1e4, make_ground_height, TermRole::constraint},
      {"swing_height", "-", 1e3, make_swing_height, TermRole::constraint},
      {"flat_foot", "-", 1e4, make_flat_foot, TermRole::constraint},
      {"least_normal_force", "-", 1e-3, make_least_normal_force, TermRole::constraint},
      {"joint_limits", "-", 1e-3, make_joint_limits, TermRole::constraint},
      {"torque_limits", "-", 1e-3, make_torque_limits, TermRole::constraint},
      {"stroke_limits", "-", 1e-3, make_stroke_limits, TermRole::constraint},
      {"actuator_force", "-", 1e-3, make_actuator_force, TermRole::constraint},
      // Regularisers.
      {"force_size", "-", 1e-3, make_force_size, TermRole::regulariser},
      {"force_smoothness", "-", 0.05, make_force_smoothness, TermRole::regulariser},
      {"design_tether", "-", 0.05, make_design_tether, TermRole::regulariser},
      // Outer objectives: no part of F unless a task gives them a weight.
      {"mechanical_work", "-", 0.0, make_mechanical_work, TermRole::outer},
      {"peak_torque", "-", 0.0, make_peak_torque, TermRole::outer},
      {"printed_volume", "-", 0.0, make_printed_volume, TermRole::outer},
  };
  return table;
}

}  // namespace legwright
