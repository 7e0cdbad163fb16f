// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "tools/drawables/drawn_design.hpp"
#include "tools/files/json_file.hpp"
#include "tools/studio/kept_sessions.hpp"

namespace legwright {

/// What a page offers where nothing is open: {examples, recent, unsaved, roots}.
/// @param examples folder of example robots with their tasks, or empty
Json start_json(const std::filesystem::path& examples, const KeptSessions& kept,
                const std::vector<std::filesystem::path>& roots);

/// The task file of an example, by the name that start_json() gives it. Throws InputError.
std::filesystem::path example_file(const std::filesystem::path& examples, const std::string& name);

/// The robot of an example as it stands: {bodies, geoms, poses}, to be drawn as its picture.
Json example_picture(const std::filesystem::path& file, MeshStore& meshes);

}  // namespace legwright
