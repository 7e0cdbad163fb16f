// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <functional>
#include <string>

namespace legwright {

/// STEM, or the first of STEM_2, STEM_3, … that is not taken.
std::string unused_name(const std::string& stem,
                        const std::function<bool(const std::string& name)>& is_taken);
/// The same among a model's elements of a type.
std::string unused_name(const mjModel& model, mjtObj type, const std::string& stem);

}  // namespace legwright
