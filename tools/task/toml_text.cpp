// SPDX-License-Identifier: Apache-2.0
#include "tools/task/toml_text.hpp"

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

std::string message_of(const toml::parse_error& error) {
  std::string text(error.description());
  if (text.find("','") != std::string::npos)
    text += " (numbers have a decimal point: 0.4, not 0,4)";
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

}  // namespace

toml::table parse_toml(const std::string& text, const std::filesystem::path& file) {
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
