// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

namespace legwright {

/// Whether a geom is of the world and no part of the robot, and robots stand on it or run into it:
/// it collides, or is a plane or a height field. Scenes have a floor of their own in its place.
bool is_of_surroundings(const mjModel& model, int geom);

/// What the robot's file brings of such geoms: "plane 'floor'", "3 boxes" …, in the order of the
/// file, those without name counted together.
std::vector<std::string> surroundings_of(const mjModel& model);

/// "surroundings in its file: plane 'floor' …; …"; empty where it brings none.
std::string describe_surroundings(const std::vector<std::string>& surroundings);

/// Whether they have ground to stand on: a plane or a height field that collides, or what is called
/// floor.
bool has_ground(const mjModel& model);

}  // namespace legwright
