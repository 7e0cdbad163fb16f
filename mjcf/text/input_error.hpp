// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace legwright {

/// Bad input, told so that it can be mended: `file:line: element or key: what is wrong; how to fix
/// it`. Programs turn it into exit code 2.
class InputError : public std::runtime_error {
 public:
  /// @param line 1-based; 0 where no line is known.
  InputError(const std::string& file, int line, const std::string& where,
             const std::string& message)
      : std::runtime_error(compose(file, line, where, message)),
        file_(file),
        line_(line),
        where_(where),
        message_(message) {}
  explicit InputError(const std::string& message)
      : std::runtime_error(without_zeros(message)), message_(message) {}

  /// Several reasons at once, a line each. @param reasons at least one
  explicit InputError(std::vector<InputError> reasons)
      : std::runtime_error(lines(reasons)), reasons_(std::move(reasons)) {}

  /// What an error of several reasons consists of; empty for a single one.
  const std::vector<InputError>& reasons() const { return reasons_; }
  /// The parts that what() is made of; no file, line and place for an error told in one string.
  const std::string& file() const { return file_; }
  int line() const { return line_; }
  const std::string& where() const { return where_; }
  const std::string& message() const { return message_; }

 private:
  static std::string compose(std::string text, int line, const std::string& where,
                             const std::string& message) {
    if (line > 0) text.append(":").append(std::to_string(line));
    text.append(": ");
    if (!where.empty()) text.append(where).append(": ");
    return without_zeros(text.append(message));
  }

  /// Names may hold bytes of zero ("a\u0000b" in TOML and JSON), at which what() would end.
  static std::string without_zeros(std::string text) {
    for (std::size_t at = 0; (at = text.find('\0', at)) != std::string::npos;)
      text.replace(at, 1, "\xEF\xBF\xBD");  // U+FFFD
    return text;
  }

  static std::string lines(const std::vector<InputError>& reasons) {
    std::string text;
    for (const InputError& reason : reasons)
      text.append(text.empty() ? "" : "\n").append(reason.what());
    return text;
  }

  std::vector<InputError> reasons_;
  std::string file_;
  int line_ = 0;
  std::string where_, message_;
};

}  // namespace legwright
