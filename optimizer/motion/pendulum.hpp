// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimizer/motion/task.hpp"

namespace legwright {

/// How the COM has to sway so that the feet can carry it by their middles: the periodic path of a
/// linear inverted pendulum, ẍ = (x − p) g/z, whose p is the centre of pressure that goes from
/// stance foot to stance foot of the footprint; on a slope g is what presses on the ground, and p
/// lies so much farther up. For robots on two feet that is no small thing: a COM that shall stay on
/// its line makes them walk on a rope.
/// @param footprint foot − COM in the middle of its stance, on the ground, heading frame, per foot
/// [m].
/// @param com_height z [m].
/// @return COM off the wanted path at each knot: forward, left [m], like Task::com_path. Source:
/// Kajita et al. 2001.
std::vector<Eigen::Vector2d> pendulum_path(const Task& task,
                                           const std::vector<Eigen::Vector2d>& footprint,
                                           double com_height);

}  // namespace legwright
