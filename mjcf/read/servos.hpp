// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include "mjcf/read/robot_model.hpp"
#include "mjcf/read/structure.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// The servo of each joint of the morphology, in its order: gains and torque limit at the joint,
/// for a linear actuator along its tendon.
/// Reasons are a joint without actuator, with several, or with one that has no torque
/// limit to take gains from, for muscles and dynamics other than a filter or an integrator in front
/// of a position servo, and for an actuator that drives anything else than one of these
/// joints, their linear actuators, and what is held in the home pose.
/// Joints of which there is one are left out.
/// @param s the design that the file holds.
std::vector<Servo> read_servos(const XmlFile& xml, const mjModel& model, const Structure& structure,
                               const Morphology& morphology, const Eigen::VectorXd& s,
                               Refusals& reasons);

/// "actuators that filter their controls: knee (0.05 s), …; gaits are …": what actuators of a file
/// have that servos of scenes do not; empty where there is nothing.
std::string describe_dynamics(const std::vector<Servo>& servos);

/// Puts the gains of servos into a morphology's joints, those of linear actuators about the joint.
/// @param s the design at which their moment arms are taken.
void set_gains(const std::vector<Servo>& servos, const Eigen::VectorXd& s, Morphology& morphology);

}  // namespace legwright
