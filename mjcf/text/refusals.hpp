// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "mjcf/text/input_error.hpp"

namespace legwright {

/// Reasons to refuse a file, collected so that all are reported at once: one line each, every one
/// with its place and cure.
class Refusals {
 public:
  /// @param reason may be several at once
  void add(const InputError& reason) {
    for (const InputError& each : reason.reasons()) add(each);
    if (!reason.reasons().empty()) return;
    for (const InputError& known : reasons_)
      if (std::string_view(known.what()) == reason.what()) return;
    reasons_.push_back(reason);
  }
  /// Does some work, whose refusal becomes a reason. @return whether it was done
  template <class Work>
  bool collect(const Work& work) {
    try {
      work();
      return true;
    } catch (const InputError& fault) {
      add(fault);
      return false;
    }
  }
  bool empty() const { return reasons_.empty(); }
  const std::vector<InputError>& all() const { return reasons_; }
  /// Throws one InputError with all reasons, if there are some, in the order of the file; those
  /// without a line come last. A single reason is thrown as it is.
  void throw_if_any() const {
    if (reasons_.empty()) return;
    if (reasons_.size() == 1) throw InputError(reasons_.front());
    std::vector<InputError> sorted = reasons_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const InputError& a, const InputError& b) {
      return b.line() <= 0 ? a.line() > 0 : a.line() > 0 && a.line() < b.line();
    });
    throw InputError(std::move(sorted));
  }

 private:
  std::vector<InputError> reasons_;
};

}  // namespace legwright
