// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/played_state.hpp"

#include <cmath>

#include "plugin/spline.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/planned_vectors.hpp"
#include "tools/simulate/root_motion.hpp"

namespace legwright {

JointMap map_joints(const mjModel& model, const std::vector<std::string>& joint_names) {
  JointMap map;
  for (int j = 0; j < model.njnt && map.root_body < 0; ++j) {
    if (model.jnt_type[j] != mjJNT_FREE) continue;
    map.root_body = model.jnt_bodyid[j];
    map.root_qpos = model.jnt_qposadr[j];
    map.root_dof = model.jnt_dofadr[j];
  }
  if (map.root_body < 0) throw MujocoError("the model has no free joint: its trunk cannot move");
  for (const auto& name : joint_names) {
    const int j = mj_name2id(&model, mjOBJ_JOINT, name.c_str());
    if (j < 0 || model.jnt_type[j] != mjJNT_HINGE) {
      throw MujocoError("the model has no hinge named '" + name + "', which the trajectory moves");
    }
    map.joint.push_back(j);
    map.qpos.push_back(model.jnt_qposadr[j]);
    map.dof.push_back(model.jnt_dofadr[j]);
  }
  return map;
}

namespace {

// Rotation vectors of the first cycle; later ones are the same seen from a turned world. Adding the
// turn to a vector instead, as within a cycle, is right for small sums only.
RootRotation planned_rotation(const Trajectory& trajectory, SplinePhase phase) {
  const double angle = trajectory.turn * phase.cycle;
  phase.cycle = 0.0;
  Eigen::Vector3d o, rate, second;
  for (int k = 0; k < 3; ++k) {
    const auto turn = spline_point(trajectory, phase, trajectory.root_column(3 + k),
                                   k == 2 ? trajectory.turn : 0.0);
    o[k] = turn.value;
    rate[k] = turn.rate;
    second[k] = turn.acceleration;
  }
  RootRotation out = root_rotation(o, rate, second);
  if (angle == 0.0) return out;
  const double c = std::cos(angle / 2), s = std::sin(angle / 2);
  const Eigen::Vector4d q = out.quaternion;
  out.quaternion << c * q[0] - s * q[3], c * q[1] - s * q[2], c * q[2] + s * q[1],
      c * q[3] + s * q[0];
  if (out.quaternion[0] < 0) out.quaternion = -out.quaternion;
  return out;
}

}  // namespace

double robot_weight(const mjModel& model, const JointMap& map) {
  return model.body_subtreemass[map.root_body] *
         Eigen::Map<const Eigen::Vector3d>(model.opt.gravity).norm();
}

PlayedState played_state(const mjModel& model, const JointMap& map, const Trajectory& trajectory,
                         double time) {
  PlayedState state;
  state.qpos = Eigen::Map<const Eigen::VectorXd>(model.qpos0, model.nq);
  state.qvel = state.qacc = Eigen::VectorXd::Zero(model.nv);
  const SplinePhase phase = phase_at(trajectory, time);
  const PlannedPoint root = planned_point(trajectory, phase, trajectory.root_column(0));
  state.qpos.segment<3>(map.root_qpos) = root.value;
  state.qvel.segment<3>(map.root_dof) = root.rate;
  state.qacc.segment<3>(map.root_dof) = root.acceleration;
  const RootRotation rotation = planned_rotation(trajectory, phase);
  state.qpos.segment<4>(map.root_qpos + 3) = rotation.quaternion;
  state.qvel.segment<3>(map.root_dof + 3) = rotation.velocity;
  state.qacc.segment<3>(map.root_dof + 3) = rotation.acceleration;
  for (std::size_t a = 0; a < map.joint.size(); ++a) {
    const auto angle =
        spline_point(trajectory, phase, trajectory.target_column(static_cast<int>(a)));
    state.qpos[map.qpos[a]] = angle.value;
    state.qvel[map.dof[a]] = angle.rate;
    state.qacc[map.dof[a]] = angle.acceleration;
  }
  return state;
}

}  // namespace legwright
