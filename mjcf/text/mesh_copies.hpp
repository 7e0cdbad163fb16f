// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mjcf/text/robot_parts.hpp"

namespace legwright {

/// Bytes [begin, end) of a text.
struct TextRange {
  std::size_t begin = 0, end = 0;
};

/// The <mesh> elements that a rewritten text has and the text before has not, told by their names,
/// with the blanks before each: what TextEdits::copy_behind() adds. In order.
std::vector<TextRange> find_added_meshes(std::string_view before, std::string_view after);

/// The text without some of its bytes.
std::string without(const std::string& text, const std::vector<TextRange>& ranges);

/// Puts what `without` took out of a robot's text into the files that hold the bytes before it.
void put_back(const std::vector<TextRange>& ranges, const std::string& text,
              std::vector<IncludedFile>& parts, std::vector<TextSegment>& segments);

}  // namespace legwright
