// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/design/morphology.hpp"

namespace legwright::test {

/// What is compared with MuJoCo; world frame.
struct RobotState {
  double mass = 0.0;
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_momentum = Eigen::Vector3d::Zero();  // about the COM
  Eigen::Matrix3d second_moments = Eigen::Matrix3d::Zero();    // Σ m p pᵀ about the COM
  std::vector<Eigen::Vector3d> feet;
  std::vector<double> actuator_lengths;  // of linear actuators [m]
};

/// Kinematics of a morphology at design s, written independently of the optimizer's.
/// @param qpos, qvel in MuJoCo's layout: position, quaternion, joint angles; velocity, rate in the
///        trunk's frame, rates.
RobotState state_of(const Morphology& morphology, const Eigen::VectorXd& s,
                    const Eigen::VectorXd& qpos, const Eigen::VectorXd& qvel);

/// The same from MuJoCo, for the robot in this text.
class MujocoRobot {
 public:
  explicit MujocoRobot(const std::string& xml);
  ~MujocoRobot();
  MujocoRobot(const MujocoRobot&) = delete;
  MujocoRobot& operator=(const MujocoRobot&) = delete;
  int nq() const;
  int nv() const;
  RobotState state(const Morphology& names, const Eigen::VectorXd& qpos,
                   const Eigen::VectorXd& qvel) const;

 private:
  struct Engine;
  Engine* engine_;
};

/// Largest difference of two states, each quantity over its own size.
double difference(const RobotState& a, const RobotState& b);

}  // namespace legwright::test
