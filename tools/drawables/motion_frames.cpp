// SPDX-License-Identifier: Apache-2.0
#include "tools/drawables/motion_frames.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "mjcf/text/mujoco_pointers.hpp"
#include "plugin/planned_motion.hpp"
#include "plugin/spline.hpp"
#include "tools/files/base64.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/simulate/played_state.hpp"

namespace legwright {
namespace {

/// Poses of all bodies of a model, one after the other: place and quaternion.
void add_poses(const mjModel& model, const mjData& data, std::vector<float>& out) {
  for (int body = 0; body < model.nbody; ++body) {
    for (int k = 0; k < 3; ++k) out.push_back(static_cast<float>(data.xpos[3 * body + k]));
    for (int k = 0; k < 4; ++k) out.push_back(static_cast<float>(data.xquat[4 * body + k]));
  }
}

void add_point(const Point& point, std::vector<float>& out) {
  for (const double x : point) out.push_back(static_cast<float>(x));
}

}  // namespace

Json motion_frames_json(const mjModel& model, const Trajectory& trajectory, int fewest_frames) {
  const PlannedMotion planned(trajectory);
  const JointMap map = map_joints(model, trajectory.joint_names);
  const DataPointer data = make_data(model);
  const int frames = std::max(fewest_frames, 2 * trajectory.knot_count);
  std::vector<float> poses, forces, places;
  Json feet = Json::array();
  for (const std::string& name : trajectory.foot_names)
    feet.push_back({{"name", name}, {"stance", Json::array()}});
  for (int frame = 0; frame < frames; ++frame) {
    const double time = trajectory.period * frame / frames;
    const PlayedState at = played_state(model, map, trajectory, time);
    std::copy(at.qpos.begin(), at.qpos.end(), data->qpos);
    mj_kinematics(&model, data.get());
    add_poses(model, *data, poses);
    const SplinePhase phase = phase_at(trajectory, time);
    for (int foot = 0; foot < trajectory.foot_count(); ++foot) {
      feet[static_cast<std::size_t>(foot)]["stance"].push_back(planned.contact(phase, foot) ? 1
                                                                                            : 0);
      add_point(planned.force(phase, foot), forces);
      add_point(planned.foot(phase, foot), places);
    }
  }
  return {{"period", trajectory.period},
          {"frames", frames},
          {"bodies", model.nbody},
          {"poses", base64_of(poses)},
          {"advance", {trajectory.travel[0], trajectory.travel[1], trajectory.turn}},
          {"feet", feet},
          {"forces", base64_of(forces)},
          {"places", base64_of(places)}};
}

}  // namespace legwright
