// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/files/io_error.hpp"

namespace legwright {

/// The plugin is not where it was looked for, or cannot be loaded: the installation's fault, not
/// the scene's, hence exit code 3.
class PluginError : public IoError {
 public:
  using IoError::IoError;
};

// A build of the plugin serves one release of MuJoCo, which its file names. There is one for the
// program itself, and one for each other release that the build was asked for
// (LEGWRIGHT_PLUGIN_VERSIONS).

/// The release that a plugin's file serves, as "4.0.1", read without loading it; nothing where the
/// file cannot be read or names none.
std::optional<std::string> served_mujoco(const std::filesystem::path& file);

/// Where the plugin for the MuJoCo `version` ("4.0.1") is looked for, best first: the file that the
/// environment variable LEGWRIGHT_PLUGIN names (then nowhere else), mujoco_plugin/ and
/// legwright_plugins/VERSION/ beside the running program, the same in the build tree.
std::vector<std::filesystem::path> plugin_candidates(const std::string& version);

/// The first of them that is there and serves no other version, or nothing.
std::optional<std::filesystem::path> find_plugin(const std::string& version);

/// The same, but throws PluginError with where it was looked for, what is there instead, and how to
/// get it.
std::filesystem::path require_plugin(const std::string& version);

/// The other releases of MuJoCo for which there is a plugin beside the running program.
std::vector<std::string> other_served_mujocos();

}  // namespace legwright
