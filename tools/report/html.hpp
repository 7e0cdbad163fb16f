// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/files/escape.hpp"

namespace legwright {

/// The head of a table's column.
struct TableColumn {
  std::string head;
  std::optional<std::string_view> style{};  // "n" over numbers
};

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
  /// A paragraph in small print.
  Html& note(std::string_view text, std::string_view style = "note");
  /// A cell that holds a number. @param label its column, for pages too narrow for a table's head
  Html& number(std::string_view text, std::optional<std::string_view> label = std::nullopt);
  /// A table up to its first row, with the heads of its columns; close table and tbody after it.
  Html& open_table(std::string_view style, const std::vector<TableColumn>& columns);
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
