// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace legwright {

/// How often a part stands in a text, overlaps counted.
inline std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

/// Whether the parts stand in a text one behind the other: its values, whatever the words between.
inline testing::AssertionResult in_order(const std::string& text,
                                         std::initializer_list<const char*> parts) {
  std::size_t at = 0;
  for (const std::string part : parts) {
    const std::size_t found = text.find(part, at);
    if (found == std::string::npos)
      return testing::AssertionFailure()
             << "no \"" << part << "\" behind \"" << text.substr(0, at) << "\" in: " << text;
    at = found + part.size();
  }
  return testing::AssertionSuccess();
}

}  // namespace legwright
