// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mjcf/input_error.hpp"

namespace legwright {

/// Reasons to refuse a file, collected so that all are told at once: one line each, every one with
/// its place and cure.
class Refusals {
 public:
  void add(const InputError& reason) {
    const std::string line = reason.what();
    if (("\n" + text_ + "\n").find("\n" + line + "\n") != std::string::npos) return;
    text_.append(text_.empty() ? "" : "\n").append(line);
  }
  bool empty() const { return text_.empty(); }
  /// Throws one InputError with all reasons, if there are some.
  void throw_if_any() const {
    if (!text_.empty()) throw InputError(text_);
  }

 private:
  std::string text_;
};

}  // namespace legwright
