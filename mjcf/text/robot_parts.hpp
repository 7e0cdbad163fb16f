// SPDX-License-Identifier: Apache-2.0
// What a robot's one text is made of; RobotFiles (robot_files.hpp) has them all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace legwright {

// A file's `path` is what it is called from the folder of the main file (named_path()). Where
// RobotFiles::gathered() it is below that folder, without `.` and `..`: where a copy must have it.

/// A file whose elements an <include> puts into the robot.
struct IncludedFile {
  std::filesystem::path path;
  std::string text;
};

/// A mesh, texture, height field or skin.
struct AssetFile {
  std::filesystem::path path;
  std::filesystem::path source;  // where it is read
  std::uintmax_t bytes = 0;
  bool may_link = false;  // nobody changes the source: a hard link is as good as a copy
};

/// Bytes of a robot's text that come from one of its files. Between two segments stands a line end
/// that is in no file, so that each line comes from one.
struct TextSegment {
  std::size_t begin = 0, size = 0;  // in the text
  std::size_t part = 0;             // 0: the main file, else the included ones in their order
  std::size_t source = 0;           // offset in that file
};

/// Where a file is named: by an <include> or an asset.
struct FileMention {
  std::filesystem::path path;
  std::filesystem::path source;  // where it was read
  std::string file;
  int line = 0;
  std::string where;
};

}  // namespace legwright
