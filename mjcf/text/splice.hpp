// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mjcf/text/file_reach.hpp"
#include "mjcf/text/robot_parts.hpp"
#include "mjcf/text/xml.hpp"

namespace legwright {

/// A robot's files in one text; RobotFiles says what the parts mean.
struct SplicedText {
  std::vector<IncludedFile> parts;
  std::string text;
  std::vector<TextSegment> segments;
  std::vector<FileMention> mentions;
  bool gathered = true;           // each <include> names its file by its path, below the folder
  std::unique_ptr<XmlFile> main;  // the text as XML, where nothing is included; else null
};

/// The text of a robot's main file. Throws InputError where there is none, std::system_error where
/// it cannot be read.
std::string read_main_file(const std::filesystem::path& file);

/// Puts the elements of included files into the place of each <include>, as MuJoCo does: what
/// counts of an included file are the elements in its root. Refused, at the <include>: what
/// find_file() refuses, a file that is included twice or by itself, chains of more than 8
/// files, more than 100 files. What is not there from the folder of the main file is looked for
/// beside the file that includes it. Throws InputError, std::system_error.
SplicedText splice_includes(std::string text, const std::filesystem::path& file,
                            const FileReach& reach);

/// MuJoCo knows <include> by any case.
bool is_include(const XmlElement& element);

}  // namespace legwright
