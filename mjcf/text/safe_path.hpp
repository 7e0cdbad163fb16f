// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace legwright {

/// A file that a model refers to, or why it is not read.
struct FoundFile {
  std::filesystem::path path;    // relative to the model's folder, without `.` and `..`
  std::filesystem::path source;  // as it is opened
  std::uintmax_t bytes = 0;
  std::string fault;  // what is wrong and how to mend it; empty: a regular file inside the folder
};

/// Looks up a file by the path that stands in a model. Only regular files in the model's folder and
/// the folders below it will do, also behind symbolic links: a copy of the folder is then a copy of
/// the model. Nothing is opened, so that a pipe or a device cannot block.
/// @param folder of the model's main file; empty: the current one.
FoundFile find_in_folder(const std::filesystem::path& folder, const std::string& reference,
                         std::uintmax_t most_bytes);

/// The same path without `.` and `..`, relative to the model's folder; empty where it is absolute
/// or leads out of the folder.
std::filesystem::path path_below(const std::filesystem::path& reference);

/// The bytes of a regular file, at most `most`. Pipes, devices and folders are not waited for.
/// Throws InputError for what is no such file, std::system_error where it cannot be read.
std::string read_regular_file(const std::filesystem::path& file, std::size_t most);

}  // namespace legwright
