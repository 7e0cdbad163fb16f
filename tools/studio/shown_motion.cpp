// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/shown_motion.hpp"

#include <cstddef>

#include "tools/drawables/motion_frames.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/plan.hpp"
#include "tools/simulate/played_state.hpp"
#include "tools/studio/faults.hpp"

namespace legwright {
namespace {

int body_of_foot(const mjModel& model, const Foot& foot, const JointMap& map) {
  return foot.link == 0 ? map.root_body
                        : model.jnt_bodyid[map.joint[static_cast<std::size_t>(foot.link) - 1]];
}

Json payload_json(const Task& task, int root) {
  Json out = Json::array();
  if (!task.payload) return out;
  const Payload& payload = *task.payload;
  const auto& p = payload.position;
  const auto& e = payload.size;
  out.push_back({{"body", root},
                 {"name", "payload"},
                 {"type", "box"},
                 {"size", {e.x() / 2, e.y() / 2, e.z() / 2}},
                 {"pos", {p.x(), p.y(), p.z()}},
                 {"quat", {1, 0, 0, 0}},
                 {"rgba", {0.45, 0.35, 0.25, 1}},
                 {"mesh", nullptr},
                 {"group", 0}});
  return out;
}

// Of a predicted motion, as it is until the solved one comes: half of what is sent, and read, while
// somebody's hand moves the body.
constexpr int kPredictedFrames = kFewestFrames / 2;

}  // namespace

Json motion_json(const SessionState& state, int task, const mjModel& model) {
  const auto k = static_cast<std::size_t>(task);
  const Objective& objective = *state.problem->objectives.at(k);
  const Morphology& morphology = objective.morphology();
  const Trajectory trajectory = planned_trajectory(objective, state.now->tasks.at(k).m);
  const JointMap map = map_joints(model, trajectory.joint_names);
  const bool predicted = !state.settled();
  Json out = motion_frames_json(model, trajectory, predicted ? kPredictedFrames : kFewestFrames);
  for (std::size_t foot = 0; foot < morphology.feet.size(); ++foot) {
    const Foot& one = morphology.feet[foot];
    out["feet"][foot]["body"] = body_of_foot(model, one, map);
    out["feet"][foot]["radius"] = one.radius;
  }
  out["root"] = map.root_body;
  out["task"] = task;
  out["name"] = state.problem->task(task).name;
  out["weight"] = morphology.total_mass() * kGravity;
  out["extra"] = payload_json(objective.task(), map.root_body);
  out["faults"] = faults_json(state, task, model);
  const Eigen::Vector3d& up = objective.task().up;
  out["up"] = {up.x(), up.y(), up.z()};
  out["step"] = objective.task().step_over;
  out["predicted"] = predicted;
  return out;
}

Json motion_on_body(const SessionState& state, int task, const mjModel& model) {
  const auto k = static_cast<std::size_t>(task);
  const Objective& objective = *state.problem->objectives.at(k);
  Json out = motion_frames_json(model, planned_trajectory(objective, state.now->tasks.at(k).m));
  for (const char* unseen : {"forces", "places", "feet"}) out.erase(unseen);
  return out;
}

}  // namespace legwright
