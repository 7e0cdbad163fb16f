// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "mjcf/read/read_robot.hpp"

namespace legwright {

/// What a scene adds to a robot.
struct SceneSettings {
  std::string trajectory;  // text of plugin/trajectory.hpp, for the plugin's `trajectory` attribute
  double period = 0.0;     // duration of one cycle [s], > 0
  Eigen::Vector3d travel = Eigen::Vector3d::Zero();  // of the plan in one cycle [m], world
  double turn = 0.0;                                 // of the plan about z in one cycle [rad]
  double t0 = 0.0;                                   // phase of the gait at time 0 [s]
  Eigen::VectorXd start_qpos;  // played pose and velocity at phase t0: keyframe "gait"
  Eigen::VectorXd start_qvel;
  double floor_friction = 0.8;
  double gain_scale = 1.0;  // kp × scale, kd × √scale
};

/// A self-contained scene: the robot's MJCF text with floor, lights, cameras, solver options, the
/// plugin legwright.gait in place of its servos, sensors and a keyframe at the start of the gait.
/// Compiles only where the plugin is loaded. Names it adds: geom "floor" ("floor_2" where the robot
/// has one; of the others the robot's own make room), cameras "side" (still;
/// the travel goes from left to right) and "track" (the same view, follows the robot), sensors
/// "tracking", "gait:KIND" and "contact:FOOT", key "gait", instance "gait". The view depends on
/// `robot` and the direction of travel and of gravity only, so designs of one robot are seen alike.
/// @param design_xml text of the robot, of `robot` or a design of it, in its surroundings. Throws
///        InputError if it does not compile, std::invalid_argument for settings that do not fit it.
std::string emit_scene(const RobotModel& robot, const std::string& design_xml,
                       const SceneSettings& settings);

}  // namespace legwright
