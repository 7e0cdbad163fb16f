// SPDX-License-Identifier: Apache-2.0
#include "tools/render/poses.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mjcf/scene/seen_shapes.hpp"
#include "mjcf/text/input_error.hpp"
#include "plugin/planned_motion.hpp"
#include "plugin/spline.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/csv_table.hpp"

namespace legwright {
namespace {

constexpr const char* kOptimizeAgain = "the file is damaged: run `legwright optimize` again";

}  // namespace

ModelPointer load_drawn_scene(const std::filesystem::path& file) {
  char message[1000] = "";
  ModelPointer model(mj_loadXML(file.c_str(), nullptr, message, sizeof message));
  if (!model) {
    std::string reason = message;
    while (reason.ends_with('\n')) reason.pop_back();
    throw InputError(file.string(), 0, "", reason + "; " + kOptimizeAgain);
  }
  hide_collision_shapes(*model);
  return model;
}

std::vector<double> start_pose(const mjModel& model) {
  const int key = std::max(mj_name2id(&model, mjOBJ_KEY, "gait"), 0);
  const double* pose =
      model.nkey > 0 ? model.key_qpos + static_cast<std::ptrdiff_t>(key) * model.nq : model.qpos0;
  return {pose, pose + model.nq};
}

Poses planned_poses(const mjModel& model, const Trajectory& plan, int count,
                    const std::filesystem::path& scene) {
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(std::max(count, 0)));
  for (int k = 0; k < count; ++k) times.push_back(plan.period * k / count);
  return planned_poses(model, plan, times, scene);
}

Poses planned_poses(const mjModel& model, const Trajectory& plan, const std::vector<double>& times,
                    const std::filesystem::path& scene) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(scene.string(), 0, "", what + "; " + kOptimizeAgain);
  };
  int root = -1;
  for (int j = 0; j < model.njnt && root < 0; ++j) {
    if (model.jnt_type[j] == mjJNT_FREE) root = model.jnt_qposadr[j];
  }
  if (root < 0) refuse("the scene has no free root to place");
  std::vector<int> address;
  for (const std::string& name : plan.joint_names) {
    const int joint = mj_name2id(&model, mjOBJ_JOINT, name.c_str());
    if (joint < 0) refuse("the scene has no joint named '" + name + "', the plan has");
    address.push_back(model.jnt_qposadr[joint]);
  }
  Poses poses;
  const PlannedMotion motion(plan);
  for (const double time : times) {
    const SplinePhase phase = phase_at(plan, time);
    const Pose trunk = motion.root(phase);
    std::vector<double> qpos(model.qpos0, model.qpos0 + model.nq);
    const auto place = std::copy(trunk.position.begin(), trunk.position.end(), qpos.begin() + root);
    std::copy(trunk.quaternion.begin(), trunk.quaternion.end(), place);
    for (std::size_t j = 0; j < address.size(); ++j) {
      const int column = plan.target_column(static_cast<int>(j));
      qpos[static_cast<std::size_t>(address[j])] = spline_point(plan, phase, column).value;
    }
    poses.push_back(std::move(qpos));
  }
  return poses;
}

Playback read_playback(const mjModel& model, const std::filesystem::path& file) {
  const CsvTable table = parse_csv_table(read_file(file), file.string(), "validate");
  if (table.columns.size() != static_cast<std::size_t>(model.nq) + 1) {
    throw InputError(file.string(), 0, "",
                     std::to_string(table.columns.size()) + " columns, expected time and " +
                         std::to_string(model.nq) +
                         " of qpos; it is not of this scene: run `legwright validate` again");
  }
  Playback playback;
  for (const auto& row : table.rows) {
    playback.time.push_back(row.front());
    playback.qpos.emplace_back(row.begin() + 1, row.end());
  }
  return playback;
}

std::vector<double> pose_at(const mjModel& model, const Playback& playback, double time) {
  const auto after = std::upper_bound(playback.time.begin(), playback.time.end(), time);
  if (after == playback.time.begin()) return playback.qpos.front();
  if (after == playback.time.end()) return playback.qpos.back();
  const auto i = static_cast<std::size_t>(after - playback.time.begin());
  const double gap = playback.time[i] - playback.time[i - 1];
  std::vector<double> pose = playback.qpos[i - 1], way(static_cast<std::size_t>(model.nv));
  mj_differentiatePos(&model, way.data(), gap, pose.data(), playback.qpos[i].data());
  mj_integratePos(&model, pose.data(), way.data(), time - playback.time[i - 1]);
  return pose;
}

std::size_t record_at(const Playback& playback, double time) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < playback.time.size(); ++i) {
    if (std::abs(playback.time[i] - time) < std::abs(playback.time[best] - time)) best = i;
  }
  return best;
}

}  // namespace legwright
