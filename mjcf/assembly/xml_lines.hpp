// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>

namespace legwright {

/// Collects the lines of a file, indented.
class XmlLines {
 public:
  void add(const std::string& line) { text_ += std::string(depth_, ' ') + line + "\n"; }
  void open(const std::string& line) {
    add(line);
    depth_ += 2;
  }
  void close(const char* tag) {
    depth_ -= 2;
    add(fmt::format("</{}>", tag));
  }
  void empty() { text_ += "\n"; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t depth_ = 0;
};

}  // namespace legwright
