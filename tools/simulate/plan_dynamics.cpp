// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/plan_dynamics.hpp"

#include <algorithm>
#include <utility>

#include "plugin/spline.hpp"
#include "tools/simulate/planned_vectors.hpp"

namespace legwright {
namespace {

void set_state(const PlayedState& state, mjData& data) {
  std::copy_n(state.qpos.data(), state.qpos.size(), data.qpos);
  std::copy_n(state.qvel.data(), state.qvel.size(), data.qvel);
  std::copy_n(state.qacc.data(), state.qacc.size(), data.qacc);
}

// Contact, limit and friction forces are not part of the plan: the inverse without constraints is
// M q̈ + bias − passive.
ModelPointer without_constraints(const mjModel& model) {
  ModelPointer copy(mj_copyModel(nullptr, &model));
  if (!copy) throw std::bad_alloc();
  copy->opt.disableflags |= mjDSBL_CONSTRAINT | mjDSBL_ACTUATION;
  copy->opt.enableflags &= ~mjENBL_INVDISCRETE;
  return copy;
}

}  // namespace

PlanDynamics::PlanDynamics(const mjModel& model, const Trajectory& plan,
                           std::vector<FootOnBody> feet)
    : plan_(plan),
      model_(without_constraints(model)),
      data_(make_data(*model_)),
      map_(map_joints(*model_, plan.joint_names)),
      feet_(std::move(feet)),
      weight_(robot_weight(model, map_)),
      jacobian_(3, model.nv) {}

const Eigen::VectorXd& PlanDynamics::unexplained(double time) {
  const MujocoMessages messages;
  const SplinePhase phase = phase_at(plan_, time);
  set_state(played_state(*model_, map_, plan_, time), *data_);
  mj_inverse(model_.get(), data_.get());
  force_ = Eigen::Map<const Eigen::VectorXd>(data_->qfrc_inverse, model_->nv);
  for (int j = 0; j < plan_.foot_count(); ++j) {
    const Eigen::Vector3d planned = planned_force(plan_, phase, j);
    if (planned.isZero(0)) continue;
    const FootOnBody& foot = feet_[static_cast<std::size_t>(j)];
    Eigen::Vector3d point = planned_point(plan_, phase, plan_.foot_column(j, 0)).value;
    point.z() -= foot.radius;
    mj_jac(model_.get(), data_.get(), jacobian_.data(), nullptr, point.data(), foot.body);
    force_ -= jacobian_.transpose() * planned;
  }
  return force_;
}

}  // namespace legwright
