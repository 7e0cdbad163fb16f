// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <optional>

#include "mjcf/propose/floating_root.hpp"

namespace legwright {

/// The chain of bodies from the world to the trunk with three slides and three hinges that span
/// space; see find_six_joint_root(). The axes are looked at with all joints at rest.
std::optional<SixJointRoot> find_floating_chain(const mjModel& model);

}  // namespace legwright
