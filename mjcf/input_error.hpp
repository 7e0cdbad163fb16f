// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace legwright {

/// Bad input, told so that it can be mended: `file:line: element or key: what is wrong; how to fix
/// it`. Programs turn it into exit code 2.
class InputError : public std::runtime_error {
 public:
  /// @param line 1-based; 0 where no line is known.
  InputError(const std::string& file, int line, const std::string& where,
             const std::string& message)
      : std::runtime_error(compose(file, line, where, message)) {}
  explicit InputError(const std::string& message) : std::runtime_error(message) {}

 private:
  static std::string compose(std::string text, int line, const std::string& where,
                             const std::string& message) {
    if (line > 0) text.append(":").append(std::to_string(line));
    text.append(": ");
    if (!where.empty()) text.append(where).append(": ");
    return text.append(message);
  }
};

}  // namespace legwright
