// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/numbers.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

namespace legwright {
namespace {

TEST(Numbers, ReadsPlainDecimals) {
  EXPECT_EQ(parse_number("0.25"), 0.25);
  EXPECT_EQ(parse_number("-3"), -3.0);
  EXPECT_EQ(parse_number("1e-3"), 1e-3);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("+0.04"), 0.04);
  EXPECT_EQ(parse_number("+1e+3"), 1e3);
  const auto list = parse_numbers(" 1\t2\n 3 ");
  ASSERT_TRUE(list);
  EXPECT_EQ(*list, (std::vector<double>{1, 2, 3}));
  EXPECT_TRUE(parse_numbers("")->empty());
}

TEST(Numbers, RefusesEverythingElse) {
  for (const char* word : {"",       "nan",   "NaN", "inf",   "-inf", "infinity", "0x10", "1,5",
                           "1.5abc", "1e999", "+-1", "++1",   "+",    "+inf",     "+nan", "+0x10",
                           "1 2",    "1e",    "--1", "1_000", "½",    "1.5.2"})
    EXPECT_FALSE(parse_number(word)) << word;
  EXPECT_FALSE(parse_numbers("1 2 nan"));
}

TEST(Numbers, ExplainsACommaAndNamesTheWord) {
  EXPECT_NE(explain_bad_number("1 0,06").find("'0,06' is not a number; write a decimal point"),
            std::string::npos);
  EXPECT_NE(explain_bad_number("1 nan").find("'nan' is not a finite"), std::string::npos);
}

TEST(Numbers, IgnoresTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_ALL, name)) break;  // as a control where one is installed
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(format_number(1.5), "1.5");
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Numbers, WrittenNumbersReadBackAsTheSameBits) {
  std::mt19937_64 random(3);
  int count = 0;
  while (count < 10000) {
    const std::uint64_t bits = random();
    double value = 0.0;
    static_assert(sizeof value == sizeof bits);
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value) || (value != 0.0 && std::abs(value) < 1e-300)) continue;
    ASSERT_EQ(parse_number(format_number(value)), value);
    ++count;
  }
  EXPECT_EQ(format_number(-0.0), "0");
  EXPECT_EQ(format_numbers(Eigen::Vector3d(1, -0.5, 1e-7)), "1 -0.5 1e-07");
}

TEST(Numbers, RoundingLeavesTwelveDigits) {
  EXPECT_EQ(format_number(rounded(0.8400000000000001)), "0.84");
  EXPECT_EQ(format_number(rounded(0.1 + 0.2)), "0.3");
  EXPECT_EQ(format_number(rounded(-1234.567890123456)), "-1234.56789012");
  EXPECT_EQ(format_number(rounded(1.00000000001)), "1.00000000001");  // a digit that is kept
  EXPECT_EQ(format_number(rounded(1.0000000000001)), "1");
  EXPECT_EQ(rounded(0.0), 0.0);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1e3, 1e3);
  for (int k = 0; k < 10000; ++k) {
    const double value = uniform(random), once = rounded(value);
    EXPECT_LE(std::abs(once - value), 5.1e-12 * std::abs(value));
    EXPECT_EQ(rounded(once), once);
    EXPECT_LE(format_number(once).size(), 18u);
  }
}

TEST(Numbers, OfOneThingLoseTheRoundingErrorOfTheLargest) {
  EXPECT_EQ(format_numbers(rounded(Eigen::Vector3d(0.2, 1e-17, -3e-17))), "0.2 0 0");
  EXPECT_EQ(format_numbers(rounded(Eigen::Vector3d(1e-9, 1e-17, 0.0))), "1e-09 1e-17 0");
}

}  // namespace
}  // namespace legwright
