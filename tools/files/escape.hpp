// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace legwright {

// One escape per context; each takes any bytes and gives clean UTF-8.
/// For text between tags.
std::string escape_text(std::string_view text);
/// For an attribute's value in double quotes.
std::string escape_attribute(std::string_view text);
/// For JSON that stands in a <script> element: the same document, with < > & and line separators as
/// \uXXXX.
std::string escape_json_island(std::string_view json);
/// For a paragraph of Markdown: nothing in it is markup.
std::string escape_markdown(std::string_view text);

/// data: URI of some bytes.
std::string data_uri(std::string_view media_type, std::span<const std::uint8_t> bytes);

}  // namespace legwright
