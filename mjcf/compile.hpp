// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <filesystem>
#include <memory>
#include <string>

namespace legwright {

struct MujocoDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
  void operator()(mjSpec* spec) const { mj_deleteSpec(spec); }
};
using ModelPointer = std::unique_ptr<mjModel, MujocoDeleter>;
using DataPointer = std::unique_ptr<mjData, MujocoDeleter>;

/// Compiles MJCF text that refers to no other file. Throws InputError with MuJoCo's reason, `file`
/// for messages. MuJoCo neither prints, writes a log file nor ends the process meanwhile; calls
/// take turns.
ModelPointer compile_mjcf(const std::string& xml, const std::filesystem::path& file);

/// Name of an object of the model, empty if it has none.
std::string name_of(const mjModel& model, mjtObj type, int id);

}  // namespace legwright
