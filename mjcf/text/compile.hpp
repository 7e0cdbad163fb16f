// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <filesystem>
#include <functional>
#include <string>

#include "mjcf/text/mujoco_pointers.hpp"

namespace legwright {

/// Runs `work`, which calls the engine: an engine error becomes an InputError at `file`, warnings
/// are dropped, and nothing is printed, logged or ended. Messages of other threads go to the
/// handler that was set before. Calls take turns and must not nest.
void call_engine(const std::filesystem::path& file, const std::function<void()>& work);

/// Makes the textures that MuJoCo would paint itself as small as can be: of a model that nobody
/// looks at. Painting them takes longer than the rest of a compilation.
void shrink_painted_textures(mjSpec& spec);

/// Lets MuJoCo paint the textures that come from picture files itself, one colour all over: of a
/// model that nobody looks at, whose pictures need not be read.
void paint_over_pictures(mjSpec& spec);

/// What a model shall have of its mesh files: all triangles, or no more than what moves, touches
/// and weighs (put_hulls_for_meshes), which is compiled in a small part of the time.
enum class MeshDetail { hulls, triangles };

/// Compiles the text of a model's files (RobotFiles::text), in which no <include> is left. Assets
/// are read from the folder of `file`: only RobotFiles, which looks at each of them, may be the
/// source of a text that names some. Throws InputError with MuJoCo's reason, `file` for messages.
/// MuJoCo neither prints, writes a log file nor ends the process meanwhile; calls take turns.
/// Its painted textures are small.
ModelPointer compile_mjcf(const std::string& xml, const std::filesystem::path& file,
                          MeshDetail detail = MeshDetail::hulls);

/// What the text's <option> says, where MuJoCo's defaults hold for the rest; nothing is compiled.
/// Throws as compile_mjcf().
mjOption options_of_mjcf(const std::string& xml, const std::filesystem::path& file);

/// The model's state in a pose, with the places of bodies and geoms. Throws InputError at `file`
/// where the engine fails, as for want of memory.
/// @param qpos nq numbers; null: the reference pose.
DataPointer kinematics_at(const mjModel& model, const mjtNum* qpos,
                          const std::filesystem::path& file);

/// Name of an object of the model, empty if it has none.
std::string name_of(const mjModel& model, mjtObj type, int id);

}  // namespace legwright
