// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <vector>

#include "plugin/trajectory.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/played_state.hpp"

namespace legwright {

/// Where a ball foot's planned force acts.
struct FootOnBody {
  int body = 0;
  double radius = 0.0;  // [m]
};

/// MuJoCo's inverse dynamics of the played motion: M q̈ + bias − passive forces (gravity, armature,
/// joint damping and springs included, joint friction not) minus Jᵀ·planned force at each foot's
/// lowest point. Contacts, limits and actuators of the model take no part.
class PlanDynamics {
 public:
  /// @param feet in the trajectory's order; both references must outlive this
  PlanDynamics(const mjModel& model, const Trajectory& plan, std::vector<FootOnBody> feet);

  /// Generalised forces [N, N m] that motion and planned contact forces leave to the actuators; at
  /// the root's six (force in world axes, torque about its origin in its own) to nobody.
  /// @param time [s] since the plan's phase 0
  const Eigen::VectorXd& unexplained(double time);

  const mjModel& model() const { return *model_; }
  const mjData& data() const { return *data_; }  // in the state of the last call
  const JointMap& joints() const { return map_; }
  double weight() const { return weight_; }  // [N]

 private:
  const Trajectory& plan_;
  ModelPointer model_;
  DataPointer data_;
  JointMap map_;
  std::vector<FootOnBody> feet_;
  double weight_ = 0.0;
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> jacobian_;
  Eigen::VectorXd force_;
};

}  // namespace legwright
