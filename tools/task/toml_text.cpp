// SPDX-License-Identifier: Apache-2.0
#include "tools/task/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

constexpr int kMostKeyParts = 32;

std::string message_of(const toml::parse_error& error) {
  std::string text(error.description());
  if (text.find("','") != std::string::npos)
    text += " (numbers have a decimal point: 0.4, not 0,4)";
  if (text.find("boolean") != std::string::npos)
    text += " (a text stands in quotes: name = \"trot\")";
  return text + "; mend the TOML there, or cut the file back to the last line that is whole";
}

/// Adds the lines of what a table or an array holds, whose names from the root on are `path`.
void add_lines(const toml::node& node, std::vector<std::string>& path,
               std::vector<KeyLine>& lines) {
  const auto add = [&](std::string name, const toml::node& held) {
    path.push_back(std::move(name));
    lines.emplace_back(path, static_cast<int>(held.source().begin.line));
    add_lines(held, path, lines);
    path.pop_back();
  };
  if (const toml::table* table = node.as_table())
    for (const auto& [key, held] : *table) add(std::string(key.str()), held);
  if (const toml::array* array = node.as_array())
    for (std::size_t i = 0; i < array->size(); ++i) add(std::to_string(i), (*array)[i]);
}

/// Where a quoted text that begins at `at` ends: the place of its last quote.
std::size_t end_of_quoted(const std::string& text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool many = text.compare(at, 3, three) == 0;
  std::size_t k = at + (many ? 3 : 1);
  for (; k < text.size(); ++k) {
    if (quote == '"' && text[k] == '\\')
      ++k;
    else if (many ? text.compare(k, 3, three) == 0 : text[k] == quote || text[k] == '\n')
      return many ? k + 2 : k;
  }
  return k;
}

/// The line of the first key of too many parts, on each of which the parser calls itself; 0
/// without.
int line_of_deep_key(const std::string& text) {
  int line = 1, dots = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    char c = text[k];
    if (c == '"' || c == '\'') {
      const std::size_t end = end_of_quoted(text, k);
      line += static_cast<int>(
          std::count(text.begin() + static_cast<std::ptrdiff_t>(k),
                     text.begin() + static_cast<std::ptrdiff_t>(std::min(end, text.size())), '\n'));
      k = end;
      if (k >= text.size()) break;
      c = text[k];
    }
    if (c == '#') k = std::min(text.find('\n', k), text.size() - 1);
    c = text[k];
    if (c == '.' && ++dots >= kMostKeyParts) return line;
    if (c == '\n') ++line;
    if (c == '\n' || std::string_view("=,[]{}").find(c) != std::string_view::npos) dots = 0;
  }
  return 0;
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::filesystem::path& file) {
  if (const int line = line_of_deep_key(text); line > 0)
    throw InputError(file.string(), line, "",
                     fmt::format("a key of more than {} parts between dots; expected one like "
                                 "gait.period: mend the TOML there",
                                 kMostKeyParts));
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(file.string(), static_cast<int>(error.source().begin.line), "",
                     message_of(error));
  }
}

std::vector<KeyLine> key_lines(const std::string& text, const std::filesystem::path& file) {
  std::vector<KeyLine> lines;
  std::vector<std::string> path;
  add_lines(parse_toml(text, file), path, lines);
  return lines;
}

}  // namespace legwright
