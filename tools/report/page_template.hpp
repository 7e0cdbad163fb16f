// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace legwright {

/// What goes into a hole of a page template.
class Hole {
 public:
  /// Plain text of any origin; fill() escapes it.
  Hole(std::string_view name, std::string_view text);
  /// Markup that this program made; never anything that came from a file.
  static Hole markup(std::string_view name, std::string_view html);

  std::string_view name() const { return name_; }
  const std::string& html() const { return html_; }

 private:
  Hole() = default;
  std::string name_, html_;
};

/// Fills the holes `{name}` of a piece of literal HTML. A hole may stand in text or in an attribute
/// in double quotes, any number of times; `{{` and `}}` stand for braces.
/// Throws std::logic_error for a hole without value, a value without hole, an open brace: those are
/// faults of the program, and every template is filled by a test.
std::string fill(std::string_view page, std::initializer_list<Hole> holes);

/// Words in small print; nothing for none.
std::string small_html(std::string_view words);
/// The head of a column of numbers.
std::string number_head_html(std::string_view head);

/// What `html_of` makes of each element, one after the other.
template <class List, class HtmlOf>
std::string each(const List& list, const HtmlOf& html_of) {
  std::string out;
  for (const auto& element : list) out += html_of(element);
  return out;
}

}  // namespace legwright
