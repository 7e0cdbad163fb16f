// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/feed_forward.hpp"

#include <algorithm>
#include <cmath>

#include "tools/simulate/plan_dynamics.hpp"

namespace legwright {
namespace {

constexpr double kTurning = 0.1;  // [rad/s]

std::vector<FootOnBody> find_bodies(const mjModel& model, const JointMap& map,
                                    const std::vector<FootOnLink>& feet) {
  std::vector<FootOnBody> out;
  for (const auto& foot : feet) {
    const int joint = foot.joint.empty() ? -1 : mj_name2id(&model, mjOBJ_JOINT, foot.joint.c_str());
    out.push_back({joint < 0 ? map.root_body : model.jnt_bodyid[joint], foot.radius});
  }
  return out;
}

// ∂L/∂q of the tendon over each joint, in the state that `data` holds.
void read_arms(const mjModel& model, const mjData& data, const JointMap& map,
               Eigen::Ref<Eigen::RowVectorXd> arms) {
  for (int t = 0; t < static_cast<int>(model.ntendon); ++t)
    for (int k = model.ten_J_rowadr[t]; k < model.ten_J_rowadr[t] + model.ten_J_rownnz[t]; ++k)
      for (std::size_t a = 0; a < map.dof.size(); ++a)
        if (model.ten_J_colind[k] == map.dof[a]) arms[static_cast<Eigen::Index>(a)] = data.ten_J[k];
}

// What a joint's dry friction takes from its motor at a rate; in full from a few times kTurning on,
// less below, so that a turn of the way is no jump.
double dry_friction(const mjModel& model, int dof, double rate) {
  return model.dof_frictionloss[dof] * std::tanh(rate / kTurning);
}

}  // namespace

RootResidual fill_feed_forward(const mjModel& model, const std::vector<FootOnLink>& feet,
                               Trajectory& trajectory) {
  const JointMap map = map_joints(model, trajectory.joint_names);
  PlanDynamics dynamics(model, trajectory, find_bodies(model, map, feet));
  RootResidual residual;
  residual.arms.setZero(trajectory.knot_count, trajectory.joint_count());
  for (int knot = 0; knot < trajectory.knot_count; ++knot) {
    const Eigen::VectorXd& force = dynamics.unexplained(trajectory.at(knot, 0));
    Eigen::RowVectorXd arms = Eigen::RowVectorXd::Zero(trajectory.joint_count());
    read_arms(dynamics.model(), dynamics.data(), map, arms);
    residual.arms.row(knot) = arms;
    for (int a = 0; a < trajectory.joint_count(); ++a) {
      const int dof = map.dof[static_cast<std::size_t>(a)];
      trajectory.at(knot, trajectory.torque_column(a)) =
          force[dof] + dry_friction(model, dof, dynamics.data().qvel[dof]);
    }
    residual.force =
        std::max(residual.force, force.segment<3>(map.root_dof).norm() / dynamics.weight());
    residual.torque = std::max(residual.torque, force.segment<3>(map.root_dof + 3).norm());
  }
  return residual;
}

}  // namespace legwright
