// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <string_view>

/// MuJoCo where the system has no memory or no threads left.
namespace legwright {

/// Whether MuJoCo says with this that it got no memory: nothing is wrong with the file then, and
/// what calls the engine throws std::bad_alloc. Names of the file stand in quotes and do not
/// count.
inline bool tells_no_memory(std::string_view message) {
  return message.substr(0, message.find_first_of("'\"")).find("ould not allocate") != message.npos;
}

/// Lets the compiler of a model without meshes start no threads: they have nothing to do, and where
/// the system has none left MuJoCo ends the process.
inline void compile_without_idle_threads(mjSpec& spec) {
  if (mjs_firstElement(&spec, mjOBJ_MESH) == nullptr) spec.compiler.usethread = 0;
}

}  // namespace legwright
