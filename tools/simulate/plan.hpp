// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/objective/objective.hpp"
#include "plugin/trajectory.hpp"

namespace legwright {

/// A plan made ready to be played: the trajectory text with feed-forward torques, and where it
/// starts.
struct PlayablePlan {
  std::string trajectory;      // inline rows for the plugin
  std::string motion_csv;      // the same table for people, knot T included
  Eigen::VectorXd start_qpos;  // MuJoCo's qpos and qvel of the played motion at phase 0
  Eigen::VectorXd start_qvel;
  /// Largest root force of inverse dynamics that the plan does not explain, share of the weight.
  double root_residual = 0.0;
  /// Largest feed-forward torque over its servo's limit: above 1 the plan asks for too much.
  double torque_share = 0.0;
  Eigen::Vector3d travel = Eigen::Vector3d::Zero();  // of the plan per cycle [m]; z is 0
  double turn = 0.0;                                 // of the plan per cycle [rad]
};

/// The plan as the plugin plays it, without feed-forward torques: where body and feet are, with
/// which forces.
Trajectory planned_trajectory(const Objective& objective, const Eigen::VectorXd& m);

/// Feed-forward by MuJoCo's inverse dynamics of the played B-spline minus Jᵀ·planned forces, at
/// each knot. Travel and turn are those that the plan reached between knots 0 and T, so that the
/// played spline joins on.
/// @param robot_xml the robot with design s in it (rewrite_robot), the design of which m is the
/// motion. Throws InputError where the robot's names cannot be written into a trajectory or MuJoCo
/// refuses the robot.
PlayablePlan make_playable(const RobotModel& robot, const std::string& robot_xml,
                           const Objective& objective, const Eigen::VectorXd& m);
/// The same for what an Objective knows of layout and gait.
/// @param folder against which the asset paths in `robot_xml` are meant.
PlayablePlan make_playable(const Morphology& morphology, const std::string& robot_xml,
                           const Layout& layout, const Gait& gait, const Eigen::VectorXd& m,
                           const std::filesystem::path& folder = {});

}  // namespace legwright
