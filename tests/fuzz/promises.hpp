// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "mjcf/text/input_error.hpp"

namespace legwright::test {

/// A promise that was broken. Nobody catches it: libFuzzer keeps the input, a test fails.
class Finding : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void promise(bool kept, const std::string& what) {
  if (!kept) throw Finding(what);
}

/// A refusal tells a file and a reason that is more than a word.
inline void promise_reason(const std::string& message, const std::string& begin) {
  promise(message.starts_with(begin) && message.size() > begin.size() + 10,
          "a refusal without its file or reason: " + message);
}

/// Whether `work` is done; it may be refused by an InputError whose reasons all begin with the
/// file, and by nothing else.
template <class Work>
bool accepted(const std::filesystem::path& file, Work&& work) {
  try {
    work();
    return true;
  } catch (const InputError& error) {
    promise_reason(error.what(), file.string() + ":");
    for (const InputError& reason : error.reasons())
      promise_reason(reason.what(), file.string() + ":");
    return false;
  }
}

}  // namespace legwright::test
