// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "mjcf/text/input_error.hpp"

namespace legwright {

/// Reasons to refuse a file, collected so that all are reported at once: one line each, every one
/// with its place and cure.
class Refusals {
 public:
  void add(const InputError& reason) {
    for (const InputError& known : reasons_)
      if (std::string_view(known.what()) == reason.what()) return;
    reasons_.push_back(reason);
  }
  bool empty() const { return reasons_.empty(); }
  const std::vector<InputError>& all() const { return reasons_; }
  /// Throws one InputError with all reasons, if there are some.
  void throw_if_any() const {
    if (!reasons_.empty()) throw InputError(reasons_);
  }

 private:
  std::vector<InputError> reasons_;
};

}  // namespace legwright
