// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <utility>

#include <toml++/toml.h>

#include "mjcf/text/input_error.hpp"
#include "tools/task/task_text.hpp"
#include "tools/task/text_place.hpp"
#include "tools/task/toml_text.hpp"

namespace legwright {
namespace {

using Path = std::vector<std::string>;

/// The number of a [[task]] table; past the end of any array where it is none.
std::size_t number_of(const std::string& name) {
  std::size_t number = 0;
  for (const char c : name) {
    if (c < '0' || c > '9' || number > 100000) return std::size_t{1} << 30;
    number = 10 * number + static_cast<std::size_t>(c - '0');
  }
  return number;
}

template <class Node>
Node* child(Node* node, const std::string& name) {
  if (auto* table = node->as_table()) return table->get(name);
  if (auto* array = node->as_array()) return array->get(number_of(name));
  return nullptr;
}

template <class Node>
Node* find(Node* node, const Path& path, std::size_t depth) {
  for (std::size_t k = 0; node && k < depth; ++k) node = child(node, path[k]);
  return node;
}

/// What the text shall say.
toml::table changed(toml::table root, const Path& path, const toml::node* value) {
  toml::node* at = &root;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    toml::node* next = child(at, path[k]);
    if (!next) {
      if (!value) return root;  // nothing to take out
      if (!at->as_table())
        throw InputError(fmt::format("{}", fmt::join(path, ".")), 0, "",
                         "stands in a table that there is not");
      at->as_table()->insert(path[k], toml::table());
      next = child(at, path[k]);
    }
    at = next;
  }
  toml::table* table = at->as_table();
  if (!table)
    throw InputError(fmt::format("{}", fmt::join(path, ".")), 0, "", "stands in no table");
  if (value)
    value->visit([&](const auto& typed) { table->insert_or_assign(path.back(), typed); });
  else
    table->erase(path.back());
  return root;
}

std::size_t line_start(const std::string& text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  return before == std::string::npos ? 0 : before + 1;
}

std::size_t line_end(const std::string& text, std::size_t at) {
  const std::size_t end = text.find('\n', at);
  return end == std::string::npos ? text.size() : end + 1;
}

/// Where the next header of a table begins.
std::size_t next_header(const std::string& text, std::size_t at) {
  if (at < text.size() && text[at] == '[' && (at == 0 || text[at - 1] == '\n')) return at;
  const std::size_t found = text.find("\n[", at == 0 ? 0 : at - 1);
  return found == std::string::npos ? text.size() : found + 1;
}

/// "gait.period", with what is no bare word in quotes; numbers of [[task]] tables left out.
std::string dotted(const Path& path, std::size_t count) {
  std::string out;
  for (std::size_t k = 0; k < count; ++k) {
    if (k == 1 && path[0] == "task" && number_of(path[1]) < 100000) continue;
    const bool bare = !path[k].empty() &&
                      path[k].find_first_not_of(
                          "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-") ==
                          std::string::npos;
    out += (out.empty() ? "" : ".") + (bare ? path[k] : "\"" + path[k] + "\"");
  }
  return out;
}

/// Takes a key's lines out, with the lines of comment that stand further right below them; of a
/// table all up to the next one.
std::string taken_out(const std::string& text, const toml::node& node) {
  const std::size_t begin = line_start(text, text_offset(text, node.source().begin));
  std::size_t end = line_end(text, text_offset(text, node.source().end));
  if (node.is_table() && !node.as_table()->is_inline()) {
    end = next_header(text, line_end(text, begin));
  } else {
    while (text.compare(end, 8, "        ") == 0 &&
           text.find_first_not_of(' ', end) == text.find('#', end))
      end = line_end(text, end);
  }
  return text.substr(0, begin) + text.substr(end);
}

/// A line for a new key: above the first value of its table.
std::string put_in(const std::string& text, const toml::table& table, const Path& path,
                   const std::string& value) {
  std::size_t first = text.size();
  for (const auto& [key, node] : table)
    if (!node.is_table() || node.as_table()->is_inline())
      if (!node.is_array_of_tables())
        first = std::min(first, text_offset(text, node.source().begin));
  const std::size_t at = first < text.size()
                             ? line_start(text, first)
                             : line_end(text, text_offset(text, table.source().begin));
  return text.substr(0, at) + fmt::format("{} = {}\n", dotted({path.back()}, 1), value) +
         text.substr(at);
}

/// A new table with the key: at the end, or at that of its [[task]].
std::string put_table(const std::string& text, const toml::table& root, const Path& path,
                      const std::string& value) {
  std::size_t at = text.size();
  if (path[0] == "task" && path.size() > 2)
    if (const toml::node* next = find(static_cast<const toml::node*>(&root),
                                      {path[0], std::to_string(number_of(path[1]) + 1)}, 2))
      at = line_start(text, text_offset(text, next->source().begin));
  const std::string gap = at > 0 && text[at - 1] != '\n' ? "\n\n" : "\n";
  return text.substr(0, at) +
         fmt::format("{}[{}]\n{} = {}\n{}", gap, dotted(path, path.size() - 1),
                     dotted({path.back()}, 1), value, at < text.size() ? "\n" : "") +
         text.substr(at);
}

std::string edited(const std::string& text, const toml::table& root, const Path& path,
                   const std::optional<std::string>& value) {
  const auto* top = static_cast<const toml::node*>(&root);
  const toml::node* node = find(top, path, path.size());
  const bool header = node && node->is_table() && !node->as_table()->is_inline();
  if (!value) return node ? taken_out(text, *node) : text;
  if (node && !header) return with_value_at(text, *node, *value);
  const std::string rest = header ? taken_out(text, *node) : text;
  const toml::table again = toml::parse(rest);
  const toml::node* parent = find(static_cast<const toml::node*>(&again), path, path.size() - 1);
  if (parent && parent->is_table()) return put_in(rest, *parent->as_table(), path, *value);
  return put_table(rest, again, path, *value);
}

}  // namespace

std::string with_key(const std::string& text, const Path& path,
                     const std::optional<std::string>& value) {
  const toml::table root = parse_toml(text, "task");
  toml::table given;
  if (value) given = parse_toml("value = " + *value, fmt::format("{}", fmt::join(path, ".")));
  const toml::table wanted = changed(root, path, value ? given.get("value") : nullptr);
  try {
    std::string out = edited(text, root, path, value);
    if (toml::parse(out) == wanted) return out;
  } catch (const toml::parse_error&) {  // too intricate
  }
  std::ostringstream anew;
  anew << wanted << "\n";
  return anew.str();
}

}  // namespace legwright
