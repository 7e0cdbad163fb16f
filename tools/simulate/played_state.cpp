// SPDX-License-Identifier: Apache-2.0
#include "tools/simulate/played_state.hpp"

#include "plugin/spline.hpp"
#include "tools/simulate/mujoco_host.hpp"
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

PlayedState played_state(const mjModel& model, const JointMap& map, const Trajectory& trajectory,
                         double time) {
  PlayedState state;
  state.qpos = Eigen::Map<const Eigen::VectorXd>(model.qpos0, model.nq);
  state.qvel = state.qacc = Eigen::VectorXd::Zero(model.nv);
  const SplinePhase phase = phase_at(trajectory, time);
  Eigen::Vector3d o, rate, second;
  for (int k = 0; k < 3; ++k) {
    const double travel = trajectory.travel[static_cast<std::size_t>(k)];
    const auto position = spline_point(trajectory, phase, trajectory.root_column(k), travel);
    state.qpos[map.root_qpos + k] = position.value;
    state.qvel[map.root_dof + k] = position.rate;
    state.qacc[map.root_dof + k] = position.acceleration;
    const auto turn = spline_point(trajectory, phase, trajectory.root_column(3 + k),
                                   k == 2 ? trajectory.turn : 0.0);
    o[k] = turn.value;
    rate[k] = turn.rate;
    second[k] = turn.acceleration;
  }
  const RootRotation root = root_rotation(o, rate, second);
  state.qpos.segment<4>(map.root_qpos + 3) = root.quaternion;
  state.qvel.segment<3>(map.root_dof + 3) = root.velocity;
  state.qacc.segment<3>(map.root_dof + 3) = root.acceleration;
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
