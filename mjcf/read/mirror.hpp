// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <vector>

namespace legwright {

/// The direction of a turn in the frame of hinge `from`, as the frame of its mirror image `to` has
/// it. Where the frames of the two bodies are mirror images in the trunk's x-z plane, in the home
/// pose or as the file draws them, (n_x, n_y, n_z) becomes (−n_x, n_y, −n_z): turns are
/// pseudo-vectors. Else it is led through the trunk's frame in the home pose.
/// @param trunk body id. @param n unit, in the frame of the body that `from` moves
Eigen::Vector3d mirrored_turn(const mjModel& model, int trunk, int from, int to,
                              const Eigen::Vector3d& n);

/// Whether two hinges stand at mirrored angles in the home pose, to 0.1 rad. Where they do not, as
/// their zero is drawn elsewhere, what they carry is no mirror image once their axes are turned.
bool at_mirrored_angles(const mjModel& model, int trunk, int from, int to);

/// Of some hinges the one whose anchor is nearest to the mirror image of a hinge's in the home
/// pose; the first of equals, −1 where there is none.
int mirror_image(const mjModel& model, int trunk, int joint, const std::vector<int>& among);

}  // namespace legwright
