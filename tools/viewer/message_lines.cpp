// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/message_lines.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "tools/files/clean_text.hpp"

namespace legwright {
namespace {

constexpr std::size_t kWidth = 60;  // characters
constexpr std::string_view kMore = " ...";

/// Whether a byte of UTF-8 goes on with the character before it.
bool goes_on(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::size_t characters(const std::string& text) {
  return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), goes_on));
}

}  // namespace

std::string in_lines(const std::string& message, std::size_t size) {
  std::string text, line;
  const auto end_line = [&](std::size_t keep) {
    text += line.substr(0, keep) + "\n";
    line.erase(0, keep);
    line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
  };
  const std::string clean = terminal_text(message);
  for (std::size_t at = 0; at < clean.size();) {
    std::size_t next = at + 1;
    while (next < clean.size() && goes_on(clean[next])) ++next;
    const std::size_t before = line.size();
    line += clean.substr(at, next - at);
    at = next;
    if (line.back() == '\n') {
      line.pop_back();
      end_line(line.size());
    } else if (characters(line) > kWidth) {
      const std::size_t blank = line.rfind(' ');
      end_line(blank == std::string::npos || blank == 0 ? before : blank);
    }
  }
  text += line;
  if (text.size() <= size) return text;
  std::size_t keep = size - std::min(size, kMore.size());
  while (keep > 0 && goes_on(text[keep])) --keep;
  return text.substr(0, keep) + std::string(kMore.substr(0, size));
}

std::string without_repeats(const std::string& message) {
  std::vector<std::string> lines;
  for (std::size_t start = 0; start <= message.size();) {
    const std::size_t end = std::min(message.find('\n', start), message.size());
    const std::string line = message.substr(start, end - start);
    if (!line.empty() && std::find(lines.begin(), lines.end(), line) == lines.end())
      lines.push_back(line);
    start = end + 1;
  }
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

}  // namespace legwright
