// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/other_engine.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace legwright {
namespace {

using Frame = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

/// The robot's geom of a contact with the world and the sign of the force on it; −1 for others.
std::pair<int, double> geom_on_ground(const mjModel& model, const mjContact& contact) {
  if (contact.geom[0] < 0 || contact.geom[1] < 0) return {-1, 0.0};
  if (model.geom_bodyid[contact.geom[0]] == 0) return {contact.geom[1], 1.0};
  if (model.geom_bodyid[contact.geom[1]] == 0) return {contact.geom[0], -1.0};
  return {-1, 0.0};
}

/// Writes a force, in the contact's frame, where mj_contactForce reads it.
void set_contact_force(const mjModel& model, mjData& data, const mjContact& contact,
                       const Eigen::Vector3d& force) {
  if (contact.efc_address < 0) return;
  mjtNum* const out = data.efc_force + contact.efc_address;
  std::array<mjtNum, 6> local{force[0], force[1], force[2], 0, 0, 0};
  if (model.opt.cone == mjCONE_PYRAMIDAL && contact.dim > 1)
    mju_encodePyramid(out, local.data(), contact.friction, contact.dim);
  else
    mju_copy(out, local.data(), contact.dim);
}

/// A geom that touches the ground at several places shares its force evenly among them.
void set_ground_forces(const mjModel& model, mjData& data, const EngineStep& step) {
  std::map<int, int> places;
  for (int c = 0; c < data.ncon; ++c) ++places[geom_on_ground(model, data.contact[c]).first];
  for (int c = 0; c < data.ncon; ++c) {
    const mjContact& contact = data.contact[c];
    const auto [geom, sign] = geom_on_ground(model, contact);
    if (geom < 0) continue;
    const auto found = step.ground_force.find(geom);
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    if (found != step.ground_force.end())
      force = sign / places[geom] * (Frame(contact.frame) * found->second);
    set_contact_force(model, data, contact, force);
  }
}

void check_size(const char* what, Eigen::Index found, Eigen::Index expected) {
  if (found != expected)
    throw std::invalid_argument(fmt::format(
        "a step of the engine has {} numbers in {}, expected {}", found, what, expected));
}

}  // namespace

std::function<void(mjData&, double)> played_by(const Scene& scene, EngineStepper step) {
  return [&scene, play = std::move(step)](mjData& data, double time) {
    const mjModel& model = *scene.model;
    data.time = time;
    mj_forward(&model, &data);
    const EngineStep next = play(time);
    check_size("qpos", next.qpos.size(), model.nq);
    check_size("qvel", next.qvel.size(), model.nv);
    check_size("torque", next.torque.size(), static_cast<Eigen::Index>(scene.joints.dof.size()));
    if (!next.qpos.allFinite() || !next.qvel.allFinite() || !next.torque.allFinite()) {
      ++data.warning[mjWARN_BADQPOS].number;  // which is how a roll-out knows that it diverged
      return;
    }
    const int nq = static_cast<int>(model.nq), nv = static_cast<int>(model.nv);
    mju_zero(data.qfrc_actuator, nv);
    for (std::size_t joint = 0; joint < scene.joints.dof.size(); ++joint)
      data.qfrc_actuator[scene.joints.dof[joint]] = next.torque[static_cast<Eigen::Index>(joint)];
    set_ground_forces(model, data, next);
    mju_copy(data.qpos, next.qpos.data(), nq);
    mju_copy(data.qvel, next.qvel.data(), nv);
  };
}

}  // namespace legwright
