// SPDX-License-Identifier: Apache-2.0
#include "tools/files/shell_word.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(ShellWord, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(shell_word("runs/puppy-sideways"), "runs/puppy-sideways");
  EXPECT_EQ(shell_word("my run"), "'my run'");
  EXPECT_EQ(shell_word("it's; rm"), "'it'\\''s; rm'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace legwright
