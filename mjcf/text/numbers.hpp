// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace legwright {

/// Splits at XML white space (blank, tab, line ends); no empty words.
std::vector<std::string_view> split_words(std::string_view text);
/// Without the white space around it.
std::string_view trimmed(std::string_view text);

/// Reads one decimal number: the whole word, finite, with a point, in no locale, perhaps with one
/// plus sign in front. Nothing for "nan", "inf", "0x10", "1,5", "1.5abc", "+-1" or a number beyond
/// the range of double.
std::optional<double> parse_number(std::string_view word);

/// Reads a list of numbers between white space; nothing if one of its words is not a number.
std::optional<std::vector<double>> parse_numbers(std::string_view text);

/// Says what is wrong with the first word of a list that is not a number, and how to write it.
std::string explain_bad_number(std::string_view text);

/// Shortest text that reads back as the same double; a negative zero is written as 0.
std::string format_number(double value);

/// Numbers separated by one blank.
std::string format_numbers(const Eigen::Ref<const Eigen::VectorXd>& values);

/// The number rounded to 12 significant digits: a length to less than 1e-11 of itself, without the
/// digits that are rounding errors.
double rounded(double value);

/// Numbers of one thing, each rounded; zero where one is nothing but the rounding error of the
/// largest.
Eigen::VectorXd rounded(const Eigen::Ref<const Eigen::VectorXd>& values);

}  // namespace legwright
