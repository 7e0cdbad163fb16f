// SPDX-License-Identifier: Apache-2.0
// What of a compiled robot moves in the plan, and where its home pose is.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "mjcf/read/structure.hpp"

namespace legwright {

/// Whether the ids of a structure are ids of the model; they are for every design of its robot.
bool has_parts_of(const mjModel& model, const Structure& structure);

/// Hinges of a body that move in the plan, by joint id.
std::vector<int> moving_joints(const mjModel& model, const Structure& structure, int body);

/// The body whose hinge moves `body` in the plan: itself or one above it; the trunk moves itself.
int moving_body(const mjModel& model, const Structure& structure, int body);

/// The body whose hinge or foot a fixed body carries as the end of a link, through fixed bodies
/// alone; the body itself where it has a hinge, or carries none or several. Bodies on the trunk, or
/// on another one without a hinge, carry themselves.
int end_of_fixed(const mjModel& model, const Structure& structure, int body);

/// Where a body goes with a stretch of the body above it, in that body's frame: the first hinge, or
/// else the origin, of end_of_fixed().
Eigen::Vector3d carried_point(const mjModel& model, const Structure& structure, int body);

/// What is held, for people: a line for each reason, with the joints that it holds.
std::string held_text(const Structure& structure);

/// The keyframe that `init --write` adds to a robot whose file has none to stand in.
inline constexpr const char* kStandingKey = "legwright";

/// The keyframe of that name, else "home", else the only one; −1 if there is none of them (then the
/// home pose is that of the file).
int home_keyframe(const mjModel& model);
/// qpos of the home pose.
const mjtNum* home_qpos(const mjModel& model);

}  // namespace legwright
