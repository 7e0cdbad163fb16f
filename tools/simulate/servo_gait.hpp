// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "tools/simulate/scene.hpp"

namespace legwright {

/// The servo of a joint of the plan, as the scene has it at its gains: its force is
/// kp (L* − L) + kd (dL*/dt − dL/dt) + feed-forward, L the joint's angle or the actuator's length.
struct SceneServo {
  int actuator = -1;    // in the model
  double kp = 0.0;      // [N m/rad], of a linear one [N/m]
  double kd = 0.0;      // [N m s/rad], of a linear one [N s/m]
  bool linear = false;  // pulls along a tendon across the joint
  double limit = 0.0;   // of its force, and of the joint's; infinite if none [N m], [N]
};

/// @param joint in the order of the plan. Throws MujocoError where the joint has no actuator.
SceneServo servo_of(const Scene& scene, std::size_t joint);

/// What the plugin would have servos do at one moment, in the order of the plan's joints.
struct ServoCommand {
  Eigen::VectorXd target, velocity;  // [rad], [rad/s], of slides [m], [m/s]
  Eigen::VectorXd torque;            // feed-forward [N m], of slides [N]
};

/// The gait of a scene for players without the plugin: a copy, which outlives the scene.
class ServoGait {
 public:
  explicit ServoGait(const Scene& scene);

  /// @param time since the start [s]
  ServoCommand command(double time) const;

  double timestep = 0.0;  // of the scene [s]
  double gain_scale = 1.0;
  std::vector<int> joints;         // in the model, in the order of the plan
  std::vector<SceneServo> servos;  // of these
  const std::vector<std::string>& joint_names() const { return trajectory_.joint_names; }
  double period() const { return trajectory_.period; }

 private:
  Trajectory trajectory_;
  double start_ = 0.0;  // of what is played [s]
};

}  // namespace legwright
