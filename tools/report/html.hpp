// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/io/clean_text.hpp"

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

/// Writes markup that is HTML and well-formed XML at once. Everything is escaped but for raw().
class Html {
 public:
  using Attributes = std::initializer_list<std::pair<std::string_view, std::string_view>>;

  Html& open(std::string_view tag, Attributes attributes = {});
  /// Closes the innermost element; throws std::logic_error if there is none.
  Html& close();
  /// An element without content, like <img/>.
  Html& lone(std::string_view tag, Attributes attributes = {});
  Html& text(std::string_view text);
  /// <tag>text</tag>
  Html& element(std::string_view tag, std::string_view text, Attributes attributes = {});
  /// Markup that this program made; never anything that came from a file.
  Html& raw(std::string_view markup);

  /// The markup; throws std::logic_error where an element is still open.
  std::string take();

 private:
  void start(std::string_view tag, Attributes attributes);
  std::string out_;
  std::vector<std::string> open_;
};

}  // namespace legwright
