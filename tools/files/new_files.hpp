// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace legwright {

/// A file that a command makes at a place that its user names.
struct NewFile {
  std::filesystem::path path;
  std::string text;
};

/// Whether two paths name one place, whether a file is there or not: links are followed, dots and
/// the folder that one is in make no difference.
bool same_place(const std::filesystem::path& a, const std::filesystem::path& b);

/// Throws IoError where a file, a folder or a link is at that path already.
void refuse_existing(const std::filesystem::path& path);

/// Writes files that are not there yet, in folders that it makes where they are not: all or none.
/// Where one fails the files and folders that it made before are taken away again. Throws IoError
/// as refuse_existing() does, before anything is written, and std::system_error where the disk
/// fails.
/// @param and_then what else there is to be done: where it throws they are taken away, too
void write_new_files(
    const std::vector<NewFile>& files, const std::function<void()>& and_then = [] {});

}  // namespace legwright
