// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimizer/terms/term.hpp"
#include "tests/support/puppy.hpp"

namespace legwright::test {

/// Everything a TermContext refers to, for tests that build terms by hand: a turning trot of the
/// tied puppy with limits of angles and torques, pistons and soles, so that every term has
/// elements.
struct TermSetting {
  /// @param printed masses depend on the design; limbs may not touch the trunk.
  explicit TermSetting(bool printed = false) {
    for (Link& link : puppy.morphology.links) {
      link.joint.lower = -1.2;
      link.joint.upper = 1.2;
      link.joint.torque_limit = 0.6;
      link.joint.armature = 2e-4;
      link.joint.servo_kp = 40.0;
      link.joint.servo_kd = 0.6;
    }
    puppy.morphology.links[4].joint.line = MotorLine{0.9, 6.0};  // of a servo
    add_pistons(puppy);
    puppy.morphology.links[8].joint.line = MotorLine{150.0, 0.2};  // of the third piston
    add_soles(puppy);
    if (printed) print_bodies(puppy);
    if (printed) add_thick_capsules(puppy);
    task.velocity = {0.05, 0.1};
    task.turn_rate = 0.6;
    task.foot_heights.resize(4);  // of one hind foot: the others have swing_height
    task.foot_heights[3] = {{0.1, 0.7}, {0.02, 0.06}, 2.0};
    task.joint_angles.resize(12);
    task.joint_angles[4] = {{}, {-0.9, -1.1, -1.0}, 0.5};
    task.clearance = 0.06;  // wide against the step of central differences
    layout = Layout(puppy.morphology, puppy.space.size(), task.gait, task.planted_margin);
  }
  TermContext context() const {
    const double mass = puppy.morphology.total_mass();
    return {layout,
            puppy.morphology,
            puppy.space,
            task,
            WantedPath(task.velocity, task.turn_rate, task.gait.period()),
            puppy.morphology.leg_length,
            mass,
            mass * kGravity,
            *task.com_height,
            *task.footprint};
  }

  Puppy puppy = make_puppy(true);
  Task task = make_sideways_task(true, 8);
  Layout layout;
};

}  // namespace legwright::test
