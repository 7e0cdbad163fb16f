// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/delayed_servos.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {

DelayedServos::DelayedServos(mjModel& model, double delay)
    : model_(model),
      age_(std::max(0.0, delay / model.opt.timestep - 0.5)),
      past_(static_cast<std::size_t>(std::ceil(age_)) + 1) {}

void DelayedServos::take_over() {
  std::fill_n(model_.actuator_biastype, model_.nactuator, static_cast<int>(mjBIAS_NONE));
  std::fill_n(model_.actuator_biasprm, mjNBIAS * model_.nactuator, 0.0);
  int& integrator = model_.opt.integrator;
  if (integrator != mjINT_EULER && integrator != mjINT_IMPLICIT) integrator = mjINT_IMPLICITFAST;
}

void DelayedServos::put_late_forces(mjData& data) {
  const auto size = static_cast<long long>(past_.size());
  const auto at = [&](long long step) -> const std::vector<double>& {
    return past_[static_cast<std::size_t>(std::max(step, 0LL) % size)];
  };
  past_[static_cast<std::size_t>(steps_ % size)].assign(data.actuator_force,
                                                        data.actuator_force + model_.nout);
  const auto whole = static_cast<long long>(age_);
  const double part = age_ - static_cast<double>(whole);
  const auto &newer = at(steps_ - whole), &older = at(steps_ - whole - (part > 0.0));
  std::fill_n(data.qfrc_actuator, model_.nv, 0.0);
  for (int a = 0; a < model_.nout; ++a) {
    const auto i = static_cast<std::size_t>(a);
    data.actuator_force[a] = (1.0 - part) * newer[i] + part * older[i];
    const int row = data.moment_rowadr[a];
    for (int k = row; k < row + data.moment_rownnz[a]; ++k)
      data.qfrc_actuator[data.moment_colind[k]] += data.actuator_moment[k] * data.actuator_force[a];
  }
  for (int joint = 0; joint < model_.njnt; ++joint) {
    if (!model_.jnt_actfrclimited[joint]) continue;
    mjtNum& force = data.qfrc_actuator[model_.jnt_dofadr[joint]];
    const mjtNum* range = model_.jnt_actfrcrange + 2 * joint;
    force = std::clamp(force, range[0], range[1]);
  }
  ++steps_;
}

// mj_step, taken apart between the forces of the actuators and what follows from them.
void DelayedServos::step(mjData& data) {
  const mjModel* model = &model_;
  mj_checkPos(model, &data);
  mj_checkVel(model, &data);
  mj_fwdPosition(model, &data);
  mj_sensorPos(model, &data);
  mj_fwdVelocity(model, &data);
  mj_sensorVel(model, &data);
  mj_fwdActuation(model, &data);
  put_late_forces(data);
  mj_fwdAcceleration(model, &data);
  mj_fwdConstraint(model, &data);
  mj_sensorAcc(model, &data);
  mj_checkAcc(model, &data);
  if (model_.opt.integrator == mjINT_EULER)
    mj_Euler(model, &data);
  else
    mj_implicit(model, &data);
}

}  // namespace legwright
