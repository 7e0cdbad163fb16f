// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>

#include "mjcf/read/robot_model.hpp"
#include "mjcf/text/elements.hpp"
#include "mjcf/text/text_edits.hpp"

namespace legwright {

/// Writes how the bodies of a robot's turning parts stand at design s, where that turns their
/// joint's axis: their `quat`, in the place of any other attribute that tells it.
void write_turned_bodies(const RobotModel& robot, const mjModel& model,
                         const TreeElements& elements, const Eigen::VectorXd& s, TextEdits& edits);

}  // namespace legwright
