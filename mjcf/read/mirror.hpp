// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <vector>

namespace legwright {

/// Which axis of the trunk's frame a mirror plane lies across: its x-z plane, which parts left and
/// right of a robot that faces ±x, or its y-z plane, of one that faces ±y.
enum class Across { x = 0, y = 1 };

/// A direction of a turn in that mirror: across y (n_x, n_y, n_z) becomes (−n_x, n_y, −n_z), as
/// turns are pseudo-vectors.
Eigen::Vector3d turn_in_mirror(const Eigen::Vector3d& n, Across across);

/// A point of the trunk's frame in that mirror. @param middle where the mirror plane lies [m]
Eigen::Vector3d point_in_mirror(const Eigen::Vector3d& p, Across across, double middle = 0.0);

/// The direction of a turn in the frame of hinge `from`, as the frame of its mirror image `to` has
/// it. Where the frames of the two bodies are mirror images, in the home pose or as the file draws
/// them, it is turn_in_mirror(). Else it is led through the trunk's frame in the home pose.
/// @param trunk body id. @param n unit, in the frame of the body that `from` moves
Eigen::Vector3d mirrored_turn(const mjModel& model, int trunk, int from, int to, Across across,
                              const Eigen::Vector3d& n);

/// Whether two hinges stand at mirrored angles in the home pose, to 0.1 rad. Where they do not, as
/// their zero is drawn elsewhere, what they carry is no mirror image once their axes are turned.
bool at_mirrored_angles(const mjModel& model, int trunk, int from, int to, Across across);

/// Of some hinges the one whose anchor is nearest to the mirror image of a hinge's in the home
/// pose, in the plane through the trunk's frame or that in the middle of all hinges, as the frame
/// may be anywhere; the first of equals, −1 where there is none.
int mirror_image(const mjModel& model, int trunk, int joint, Across across,
                 const std::vector<int>& among);

}  // namespace legwright
