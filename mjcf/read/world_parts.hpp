// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

namespace legwright {

/// Whether a geom is of the world and no part of the robot, and robots stand on it or run into it:
/// it collides, or is a plane or a height field. Scenes have a floor of their own in its place.
bool is_of_surroundings(const mjModel& model, int geom);

/// The trunk: the first body with a free joint that carries other joints, else the first with a
/// free joint; −1 where there is none.
int trunk_of(const mjModel& model);

/// Whether a body of the world that moves is no part of the robot, and scenes of gaits do without
/// it: it moves freely and carries no joint, as a ball does, or it is a stand-in without any geom.
/// @param root a child of the world
bool moves_beside(const mjModel& model, int root);
/// All of these, in the order of the file.
std::vector<int> bodies_beside(const mjModel& model);

/// What the robot's file brings of geoms of the surroundings and of bodies that move beside the
/// robot: "plane 'floor'", "3 boxes", "body 'ball'" …, in the order of the file, geoms without name
/// counted together, bodies last.
std::vector<std::string> surroundings_of(const mjModel& model);

/// "surroundings in its file: plane 'floor' …; …"; empty where it brings none.
std::string describe_surroundings(const std::vector<std::string>& surroundings);

/// Whether they have ground to stand on: a plane or a height field that collides, or what is called
/// floor.
bool has_ground(const mjModel& model);

}  // namespace legwright
