// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace legwright {

/// Points with which a geom's surface reaches farthest down, or candidates for them: the bottom of
/// a ball, ends of capsules, corners of boxes, rims and vertices [m, world].
std::vector<Eigen::Vector3d> surface_points(const mjModel& model, const mjData& data, int geom);

/// Where a link would touch level ground in the pose that `data` holds: the points of its colliding
/// geoms that are about as low as its lowest, ends of capsules, corners of boxes and rims [m,
/// world].
/// @param bodies those that make up the link.
std::vector<Eigen::Vector3d> ground_points(const mjModel& model, const mjData& data,
                                           const std::vector<int>& bodies);

/// Those geoms of a link that such points belong to.
std::vector<int> ground_geoms(const mjModel& model, const mjData& data,
                              const std::vector<int>& bodies);

/// The middle of the box around points that has an edge along `ahead`, a level direction, in their
/// plane: as far from the front of a sole as from its heel, however many points either has.
Eigen::Vector3d middle_of_sole(const std::vector<Eigen::Vector3d>& points,
                               const Eigen::Vector3d& normal, const Eigen::Vector3d& ahead);

/// The upward normal of the plane through ground points, where they span a face and no mere line: a
/// flat foot [world].
std::optional<Eigen::Vector3d> normal_of_sole(const std::vector<Eigen::Vector3d>& points);

/// Whether hinges can lay a sole down wherever it shall be: they move it ahead, aside, and tilt it
/// both ways, each alone, in the pose that `data` holds. A leg without an ankle that rolls cannot.
/// @param joints the leg's hinges.
/// @param height of the robot, the unit of length [m].
bool can_lay_down(const mjData& data, const std::vector<int>& joints, const Eigen::Vector3d& sole,
                  double height);

}  // namespace legwright
