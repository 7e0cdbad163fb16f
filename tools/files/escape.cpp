// SPDX-License-Identifier: Apache-2.0
#include "tools/files/escape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tools/files/base64.hpp"
#include "tools/files/clean_text.hpp"

namespace legwright {
namespace {

template <class Replace>
std::string replaced(std::string_view text, const Replace& replace) {
  std::string out;
  for (const char c : clean_utf8(text)) {
    const std::string_view entity = replace(c);
    if (entity.empty()) {
      out += c;
    } else {
      out += entity;
    }
  }
  return out;
}

}  // namespace

std::string escape_text(std::string_view text) {
  return replaced(text, [](char c) -> std::string_view {
    return c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : "";
  });
}

std::string escape_attribute(std::string_view text) {
  return replaced(text, [](char c) -> std::string_view {
    switch (c) {
      case '&':
        return "&amp;";
      case '<':
        return "&lt;";
      case '>':
        return "&gt;";
      case '"':
        return "&quot;";
      case '\'':
        return "&#39;";
      case '`':
        return "&#96;";
      default:
        return "";
    }
  });
}

std::string escape_json_island(std::string_view json) {
  std::string clean = replaced(json, [](char c) -> std::string_view {
    return c == '<' ? "\\u003c" : c == '>' ? "\\u003e" : c == '&' ? "\\u0026" : "";
  });
  for (const auto& [separator, code] :
       {std::pair{"\xE2\x80\xA8", "\\u2028"}, {"\xE2\x80\xA9", "\\u2029"}}) {
    for (std::size_t at = clean.find(separator); at != std::string::npos;
         at = clean.find(separator)) {
      clean.replace(at, 3, code);
    }
  }
  return clean;
}

std::string escape_markdown(std::string_view text) {
  std::string out;
  for (const char c : escape_text(text)) {
    if (std::string_view("\\`*_{}[]|~$#@").find(c) != std::string_view::npos) out += '\\';
    out += c;
    // Addresses become links by themselves: break them up.
    if (out.ends_with("://")) out.replace(out.size() - 2, 2, "\\/\\/");
    if (out.ends_with("www.")) out.replace(out.size() - 1, 1, "\\.");
  }
  return out;
}

std::string data_uri(std::string_view media_type, std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return fmt::format("data:{};base64,{}", media_type, base64_of(text));
}

}  // namespace legwright
