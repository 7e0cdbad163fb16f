// SPDX-License-Identifier: Apache-2.0
#include "tools/files/json_file.hpp"

#include "tools/files/io_error.hpp"
#include "tools/files/parse_json.hpp"

namespace legwright {
namespace {

constexpr int kMostDepth = 64;

bool too_deep(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '"') in_string = !in_string;
    if (in_string && c == '\\') ++k;  // whatever it escapes
    if (in_string) continue;
    if ((c == '[' || c == '{') && ++depth > kMostDepth) return true;
    if (c == ']' || c == '}') --depth;
  }
  return false;
}

}  // namespace

Json parse_json(std::string_view text) {
  if (too_deep(text)) return Json(Json::value_t::discarded);
  return Json::parse(text, nullptr, false);
}

std::string to_text(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_line(const Json& document) {
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void write_json(const std::filesystem::path& path, const Json& document, Durability durability) {
  write_file(path, to_text(document), durability);
}

Json read_json(const std::filesystem::path& path, const std::string& remedy) {
  const std::string text = read_file(path);
  Json document = parse_json(text);
  if (document.is_discarded())
    throw IoError(path.string() + ": not a JSON document; the file is damaged, " + remedy);
  return document;
}

}  // namespace legwright
