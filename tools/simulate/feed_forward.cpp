// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/feed_forward.hpp"

#include <Eigen/Core>
#include <algorithm>

#include "plugin/spline.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/played_state.hpp"

namespace legwright {
namespace {

using RowMajor3X = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;

void set_state(const PlayedState& state, mjData& data) {
  std::copy_n(state.qpos.data(), state.qpos.size(), data.qpos);
  std::copy_n(state.qvel.data(), state.qvel.size(), data.qvel);
  std::copy_n(state.qacc.data(), state.qacc.size(), data.qacc);
}

// Contact, limit and friction forces are not part of the plan: the inverse without constraints is
// M q̈ + bias − passive.
MujocoModel without_constraints(const mjModel& model) {
  MujocoModel copy(mj_copyModel(nullptr, &model));
  if (!copy) throw MujocoError("MuJoCo cannot copy a model: out of memory?");
  copy->opt.disableflags |= mjDSBL_CONSTRAINT | mjDSBL_ACTUATION;
  copy->opt.enableflags &= ~mjENBL_INVDISCRETE;
  return copy;
}

// ∂L/∂q of the tendon over each joint, in the state that `data` holds.
void read_arms(const mjModel& model, const mjData& data, const JointMap& map,
               Eigen::Ref<Eigen::RowVectorXd> arms) {
  for (int t = 0; t < static_cast<int>(model.ntendon); ++t)
    for (int k = model.ten_J_rowadr[t]; k < model.ten_J_rowadr[t] + model.ten_J_rownnz[t]; ++k)
      for (std::size_t a = 0; a < map.dof.size(); ++a)
        if (model.ten_J_colind[k] == map.dof[a]) arms[static_cast<Eigen::Index>(a)] = data.ten_J[k];
}

}  // namespace

RootResidual fill_feed_forward(const mjModel& robot, const std::vector<FootOnLink>& feet,
                               Trajectory& trajectory) {
  const MujocoMessages messages;
  const MujocoModel model = without_constraints(robot);
  const MujocoData data = make_data(*model);
  const JointMap map = map_joints(*model, trajectory.joint_names);
  std::vector<int> bodies;
  for (const auto& foot : feet) {
    const int joint =
        foot.joint.empty() ? -1 : mj_name2id(model.get(), mjOBJ_JOINT, foot.joint.c_str());
    bodies.push_back(joint < 0 ? map.root_body : model->jnt_bodyid[joint]);
  }
  const double gravity = Eigen::Map<const Eigen::Vector3d>(model->opt.gravity).norm();
  const double weight = model->body_subtreemass[map.root_body] * gravity;
  RowMajor3X jacobian(3, model->nv);
  RootResidual residual;
  residual.arms.setZero(trajectory.knot_count, trajectory.joint_count());
  for (int knot = 0; knot < trajectory.knot_count; ++knot) {
    const double time = trajectory.at(knot, 0);
    const SplinePhase phase = phase_at(trajectory, time);
    set_state(played_state(*model, map, trajectory, time), *data);
    mj_inverse(model.get(), data.get());
    Eigen::RowVectorXd arms = Eigen::RowVectorXd::Zero(trajectory.joint_count());
    read_arms(*model, *data, map, arms);
    residual.arms.row(knot) = arms;
    Eigen::VectorXd force = Eigen::Map<const Eigen::VectorXd>(data->qfrc_inverse, model->nv);
    for (int j = 0; j < trajectory.foot_count(); ++j) {
      Eigen::Vector3d planned, point;
      for (int k = 0; k < 3; ++k) {
        planned[k] = trajectory.at(knot, trajectory.force_column(j, k));
        point[k] = spline_point(trajectory, phase, trajectory.foot_column(j, k),
                                trajectory.travel[static_cast<std::size_t>(k)])
                       .value;
      }
      if (planned.isZero(0)) continue;
      const auto foot = static_cast<std::size_t>(j);
      point.z() -= feet[foot].radius;
      mj_jac(model.get(), data.get(), jacobian.data(), nullptr, point.data(), bodies[foot]);
      force -= jacobian.transpose() * planned;
    }
    for (int a = 0; a < trajectory.joint_count(); ++a) {
      trajectory.at(knot, trajectory.torque_column(a)) =
          force[map.dof[static_cast<std::size_t>(a)]];
    }
    residual.force = std::max(residual.force, force.segment<3>(map.root_dof).norm() / weight);
    residual.torque = std::max(residual.torque, force.segment<3>(map.root_dof + 3).norm());
  }
  return residual;
}

}  // namespace legwright
