// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace legwright {

/// How far a write goes before it returns: readers always see the old or the new file, never a
/// part.
enum class Durability {
  process,  // survives the end of this process; a power cut may lose it
  power,    // file and folder are flushed to the disk first
};

/// Writes a file whole or not at all: a temporary file in the same folder, then a rename over
/// `path`, whose mode and owner stay. Links are followed: they stay links. Pipes, devices and open
/// descriptors (`/dev/stdout`) are written directly. Throws std::system_error that names the path;
/// the old file is then untouched and no temporary left.
void write_file(const std::filesystem::path& path, std::string_view bytes,
                Durability durability = Durability::power);

/// The bytes of a regular file. Throws std::system_error that names it; IoError above `most` bytes,
/// and for pipes, sockets and devices, which might never end.
std::string read_file(const std::filesystem::path& path, std::size_t most = std::size_t{64} << 20);

/// The first bytes of a regular file, at most `count`. Throws as read_file().
std::string read_head(const std::filesystem::path& path, std::size_t count);

/// Flushes a folder's entries to the disk. Throws std::system_error.
void sync_folder(const std::filesystem::path& folder);

}  // namespace legwright
