// SPDX-License-Identifier: Apache-2.0
// What a process is told once.
#include "plugin/told.hpp"

#include <gtest/gtest.h>

#include <string>

namespace legwright {
namespace {

TEST(Told, OncePerSubjectAndReasonWhateverTheNumbersAndAThousandInAll) {
  EXPECT_TRUE(first_told("a", "gear = 2, expected 1"));
  EXPECT_FALSE(first_told("a", "gear = 2, expected 1"));
  for (const char* const number : {"0.7", "-0.7", "1e-07", "-1.25e+300", "12"})
    EXPECT_FALSE(first_told("a", "gear = " + std::string(number) + ", expected 1")) << number;
  EXPECT_TRUE(first_told("b", "gear = 2, expected 1"));
  EXPECT_TRUE(first_told("a", "gear = nan, expected 1"));
  EXPECT_TRUE(first_told("a", "gain = 2, expected 1"));
  for (const char* const other : {"-", "-.", "2-e", "2e", "2.", ""})
    EXPECT_TRUE(first_told("a", "gear = " + std::string(other) + ", expected 1")) << other;
  // No more than a thousand in all: what comes later in this process is told no more.
  int told = 0;
  for (int i = 0; i < 3000; ++i) told += first_told(std::string(i, 'x'), "reason");
  EXPECT_GT(told, 900);
  EXPECT_LE(told, 1000);
}

}  // namespace
}  // namespace legwright
