// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace legwright {

std::vector<std::string_view> split_words(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kBlanks, end);
  }
  return words;
}

std::string_view trimmed(std::string_view text) {
  const auto words = split_words(text);
  return words.empty()
             ? std::string_view()
             : text.substr(words.front().data() - text.data(),
                           words.back().data() + words.back().size() - words.front().data());
}

std::optional<double> parse_number(std::string_view word) {
  // from_chars takes no plus sign; behind one it would take a minus.
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> values;
  for (const std::string_view word : split_words(text)) {
    const std::optional<double> value = parse_number(word);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::string explain_bad_number(std::string_view text) {
  for (const std::string_view word : split_words(text)) {
    if (parse_number(word)) continue;
    const std::string shown(word.substr(0, 40));
    if (word.find(',') != std::string_view::npos)
      return fmt::format("'{}' is not a number; write a decimal point, and blanks between numbers",
                         shown);
    return fmt::format("'{}' is not a finite decimal number; write it like 0.25, -3 or 1e-3",
                       shown);
  }
  return "no number is given; write it like 0.25";
}

std::string format_number(double value) { return fmt::format("{}", value == 0.0 ? 0.0 : value); }

double rounded(double value) { return parse_number(fmt::format("{:.12g}", value)).value_or(value); }

Eigen::VectorXd rounded(const Eigen::Ref<const Eigen::VectorXd>& values) {
  constexpr double kNoise = 1e-15;
  const double floor = values.size() > 0 ? kNoise * values.cwiseAbs().maxCoeff() : 0.0;
  return values.unaryExpr([&](double x) { return std::abs(x) < floor ? 0.0 : rounded(x); });
}

std::string format_numbers(const Eigen::Ref<const Eigen::VectorXd>& values) {
  std::string text;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (i > 0) text += ' ';
    text += format_number(values[i]);
  }
  return text;
}

}  // namespace legwright
