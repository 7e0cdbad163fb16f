// SPDX-License-Identifier: Apache-2.0
#include "optimizer/base/parallel.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace legwright {
namespace {

TEST(ParallelFor, CallsEachIndexOnceAtAnyThreadCount) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<int> calls(23, 0);
    parallel_for(23, threads, [&](int i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(23, 1)) << threads;
  }
  parallel_for(0, 2, [](int) { FAIL() << "there is nothing to do"; });
}

TEST(ParallelFor, ThrowsTheFirstFailureAfterAllHaveEnded) {
  std::vector<int> calls(8, 0);
  try {
    parallel_for(8, 3, [&](int i) {
      ++calls[i];
      if (i == 2 || i == 5) throw std::runtime_error(std::to_string(i));
    });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "2");
  }
  EXPECT_EQ(calls, std::vector<int>(8, 1));
}

}  // namespace
}  // namespace legwright
