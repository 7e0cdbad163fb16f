// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plugin/trajectory.hpp"
#include "tools/render/posing.hpp"
#include "tools/render/renderer.hpp"

namespace legwright {

/// Compiles a scene. Plugins that it names must have been loaded before.
/// Throws InputError with MuJoCo's message.
ModelPointer load_drawn_scene(const std::filesystem::path& file);

/// Where the scene starts: its keyframe "gait", else its first, else the model's own reference
/// pose.
std::vector<double> start_pose(const mjModel& model);

/// The plan as the plugin plays it, at `count` equally spaced phases of one cycle, as qpos of the
/// model.
/// @param scene the model's file, for messages. Throws InputError where the model lacks a joint of
/// the plan or a free root.
Poses planned_poses(const mjModel& model, const Trajectory& plan, int count,
                    const std::filesystem::path& scene);
/// The same at any times [s] since phase 0, later cycles included: a plan that turns stays on its
/// circle.
Poses planned_poses(const mjModel& model, const Trajectory& plan, const std::vector<double>& times,
                    const std::filesystem::path& scene);

/// What a simulation did, as `validate` records it.
struct Playback {
  std::vector<double> time;  // [s]
  Poses qpos;
};
/// Reads a playback: a time column, then qpos. Throws InputError where it is damaged or does not
/// fit the model, std::system_error if unreadable.
Playback read_playback(const mjModel& model, const std::filesystem::path& file);

/// The pose at a time [s] between two records, the nearest record beyond them.
std::vector<double> pose_at(const mjModel& model, const Playback& playback, double time);

/// Index of the record nearest to a time [s].
std::size_t record_at(const Playback& playback, double time);

}  // namespace legwright
