// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "mjcf/text/file_reach.hpp"

namespace legwright {

/// A file that a model refers to, or why it is not read.
struct FoundFile {
  std::filesystem::path path;    // named_path()
  std::filesystem::path source;  // as it is opened
  std::uintmax_t bytes = 0;
  std::string fault;     // what is wrong and how to mend it; empty: a regular file
  bool missing = false;  // the fault is that nothing is there
};

/// Whether a path is of another computer: with a drive ("C:\legs\leg.stl") or a backslash in front,
/// which MuJoCo takes for the root.
bool is_windows_root(std::string_view reference);
/// The path of a model as MuJoCo reads it, with slashes between folders: backslashes are such, too,
/// but in front.
std::string slashed(std::string reference);

/// Looks up a file by the path that stands in a model, as MuJoCo does: from the model's folder,
/// through `..` and symbolic links, or by an absolute path. Only regular files will do. Nothing
/// else is opened, so that a pipe or a device cannot block.
/// @param folder of the model's main file; empty: the current one.
FoundFile find_file(const std::filesystem::path& folder, const std::string& reference,
                    std::uintmax_t most_bytes, const FileReach& reach = {});

/// What a file is called that a model names: its path from the model's folder without `.` and with
/// `..` in front only; absolute where it is named so and lies elsewhere. `link/..` is no step, also
/// where `link` is a symbolic link: so MuJoCo has it. No disk is asked.
std::filesystem::path named_path(const std::filesystem::path& folder,
                                 const std::filesystem::path& reference);

/// Where a file of this name is opened. No disk is asked.
std::filesystem::path source_of(const std::filesystem::path& folder,
                                const std::filesystem::path& named);

/// The same path without `.` and `..`, relative to the model's folder; empty where it is absolute
/// or leads out of the folder.
std::filesystem::path path_below(const std::filesystem::path& reference);

/// The bytes of a regular file, at most `most`. Pipes, devices and folders are not waited for.
/// Throws InputError for what is no such file, std::system_error where it cannot be read.
std::string read_regular_file(const std::filesystem::path& file, std::size_t most);

}  // namespace legwright
