// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <vector>

#include "mjcf/text/robot_parts.hpp"

namespace legwright {

/// Names below the folder of the main file for all files of a robot, by what they are called
/// (named_path()). What lies there keeps its name, unless runs need it. What lies elsewhere gets
/// the rest of its path behind `..` (`../meshes/hip.stl` becomes `meshes/hip.stl`), or, where its
/// path is absolute, its last part in `assets/` or, if it is included, in `parts/`. `robot_` comes
/// before a name that runs need (needed_by_runs()). Where a name is taken, `-2`, `-3` … tells them
/// apart, in the order of the mentions. Assets of one file, behind links, share one name.
/// @param includes how many of the mentions are of <include>, which come first
std::map<std::filesystem::path, std::filesystem::path> gathered_names(
    const std::vector<FileMention>& mentions, std::size_t includes);

/// Whether the folders of a run hold a file of their own where a copy would have this one, like
/// scene.xml.
bool needed_by_runs(const std::filesystem::path& path);

}  // namespace legwright
