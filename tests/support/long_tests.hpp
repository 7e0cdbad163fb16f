// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string_view>

namespace legwright::test {

/// Whether LEGWRIGHT_LONG_TESTS is set, as by `tools/test --long`: tests that take long and show
/// more of what others show run as well, and those that take samples take all.
inline bool long_tests() { return std::getenv("LEGWRIGHT_LONG_TESTS") != nullptr; }

/// Prints how often a test tried what must not go wrong, for the table of `tests/tries`.
inline void tell_tries(std::string_view what, long tries) {
  std::cout << "[  TRIED   ] " << tries << " " << what << std::endl;
}

}  // namespace legwright::test

/// Ends a test that is for a long run alone.
#define LEGWRIGHT_LONG_TEST() \
  if (!legwright::test::long_tests()) GTEST_SKIP() << "tools/test --long runs it"
