// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "optimizer/terms/term.hpp"

namespace legwright {

// One factory per file of this folder; registry.cpp lists them with equation and weight.
std::unique_ptr<Term> make_travel(const TermContext& context);
std::unique_ptr<Term> make_turning(const TermContext& context);
std::unique_ptr<Term> make_style_com(const TermContext& context);
std::unique_ptr<Term> make_style_foot(const TermContext& context);
std::unique_ptr<Term> make_style_foot_height(const TermContext& context);
std::unique_ptr<Term> make_style_joint(const TermContext& context);
std::unique_ptr<Term> make_trunk_orientation(const TermContext& context);
std::unique_ptr<Term> make_nominal_pose(const TermContext& context);
std::unique_ptr<Term> make_smoothness(const TermContext& context);
std::unique_ptr<Term> make_com_position(const TermContext& context);
std::unique_ptr<Term> make_foot_position(const TermContext& context);
std::unique_ptr<Term> make_force_balance(const TermContext& context);
std::unique_ptr<Term> make_torque_balance(const TermContext& context);
std::unique_ptr<Term> make_stance_foot(const TermContext& context);
std::unique_ptr<Term> make_friction_cone(const TermContext& context);
std::unique_ptr<Term> make_limb_clearance(const TermContext& context);
std::unique_ptr<Term> make_periodicity(const TermContext& context);
std::unique_ptr<Term> make_ground_height(const TermContext& context);
std::unique_ptr<Term> make_swing_height(const TermContext& context);
std::unique_ptr<Term> make_flat_foot(const TermContext& context);
std::unique_ptr<Term> make_least_normal_force(const TermContext& context);
std::unique_ptr<Term> make_joint_limits(const TermContext& context);
std::unique_ptr<Term> make_torque_limits(const TermContext& context);
std::unique_ptr<Term> make_actuator_force(const TermContext& context);
std::unique_ptr<Term> make_stroke_limits(const TermContext& context);
std::unique_ptr<Term> make_force_size(const TermContext& context);
std::unique_ptr<Term> make_force_smoothness(const TermContext& context);
std::unique_ptr<Term> make_design_tether(const TermContext& context);
std::unique_ptr<Term> make_mechanical_work(const TermContext& context);
std::unique_ptr<Term> make_printed_volume(const TermContext& context);
std::unique_ptr<Term> make_peak_torque(const TermContext& context);

}  // namespace legwright
