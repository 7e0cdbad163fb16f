// SPDX-License-Identifier: Apache-2.0
#include "tools/task/toml_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mjcf/text/input_error.hpp"

namespace legwright {
namespace {

TEST(TomlText, TellsTheLineOfEachKeyWithTheNumbersOfEntries) {
  auto lines = key_lines(
      "name = 'a'\n"
      "[grid]\n"
      "gait.period = [0.4,\n"
      "  0.5]\n"
      "[[points]]\n"
      "robot = 'r.xml'\n"
      "[[points]]\n"
      "travel.turn_rate = 1\n",
      "study.toml");
  std::sort(lines.begin(), lines.end());
  const std::vector<KeyLine> expected{
      {{"grid"}, 2},
      {{"grid", "gait"}, 3},
      {{"grid", "gait", "period"}, 3},
      {{"grid", "gait", "period", "0"}, 3},
      {{"grid", "gait", "period", "1"}, 4},
      {{"name"}, 1},
      {{"points"}, 5},
      {{"points", "0"}, 5},
      {{"points", "0", "robot"}, 6},
      {{"points", "1"}, 7},
      {{"points", "1", "travel"}, 8},
      {{"points", "1", "travel", "turn_rate"}, 8},
  };
  EXPECT_EQ(lines, expected);
}

TEST(TomlText, TellsWhereItIsNoToml) {
  try {
    key_lines("name = 'a'\nperiod = 0,4\n", "study.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.line(), 2);
    const std::string text = error.what();
    EXPECT_EQ(text.find("study.toml:2: "), 0U) << text;
    EXPECT_NE(text.find("mend the TOML there"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace legwright
