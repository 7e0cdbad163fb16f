// SPDX-License-Identifier: Apache-2.0
#include "tools/report/svg_bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

constexpr double kWideRange = 8.0;  // from this ratio of its ends on, a range has a log axis

/// A value's place between 0 and 1 of a range, kept inside.
class Scale {
 public:
  Scale(double low, double high)
      : log_(low > 0.0 && high / low > kWideRange), low_(of(low)), high_(of(high)) {}
  double at(double value) const {
    return log_ && value <= 0.0 ? 0.0 : std::clamp((of(value) - low_) / (high_ - low_), 0.0, 1.0);
  }

 private:
  double of(double value) const { return log_ ? std::log(value) : value; }
  bool log_;
  double low_, high_;
};

std::string rectangle(const char* style, double from, double to, double y, double height) {
  if (!(to > from)) return "";
  return fmt::format(
      "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", style,
      from, y, to - from, height);
}

}  // namespace

std::string bounds_bar(double lower, double upper, double before, double after) {
  if (!(upper > lower) || !std::isfinite(before) || !std::isfinite(after)) return "";
  const auto x = [&](double value) {
    return 7.0 + 106.0 * (std::clamp(value, lower, upper) - lower) / (upper - lower);
  };
  return fmt::format(
      "<svg class=\"bounds\" viewBox=\"0 0 120 16\" role=\"img\" aria-label=\"position within "
      "bounds\">"
      "<path class=\"track\" d=\"M7 8H113M7 4v8M113 4v8\"/>"
      "<path class=\"moved\" d=\"M{0:.1f} 8H{1:.1f}\"/>"
      "<circle class=\"before\" cx=\"{0:.1f}\" cy=\"8\" r=\"4\"/>"
      "<circle class=\"after\" cx=\"{1:.1f}\" cy=\"8\" r=\"4.5\"/></svg>",
      x(before), x(after));
}

std::string range_bar(const TriedRange& range) {
  if (!(range.tested_high > range.tested_low)) return "";
  const Scale scale(range.tested_low, range.tested_high);
  const auto x = [&](double value) { return 2.0 + 316.0 * scale.at(value); };
  const double from = range.low ? x(*range.low) : 2.0, to = range.high ? x(*range.high) : 318.0;
  std::string out =
      "<svg class=\"range\" viewBox=\"0 0 320 20\" role=\"img\" aria-label=\"where the robot "
      "walks\">";
  out += rectangle("falls", 2.0, from, 5.0, 10.0) + rectangle("walks", from, to, 5.0, 10.0) +
         rectangle("falls", to, 318.0, 5.0, 10.0);
  for (const auto& end : {range.low, range.high})
    if (end) out += fmt::format("<path class=\"end\" d=\"M{:.1f} 2v16\"/>", x(*end));
  if (range.nominal)
    out += fmt::format("<circle class=\"nominal\" cx=\"{:.1f}\" cy=\"10\" r=\"4.5\"/>",
                       std::clamp(x(*range.nominal), 6.0, 314.0));
  return out + "</svg>";
}

std::string share_bar(std::optional<double> share, std::optional<double> low,
                      std::optional<double> high) {
  if (!share) return "";
  const auto x = [](double value) { return 2.0 + 316.0 * std::clamp(value, 0.0, 1.0); };
  std::string out =
      "<svg class=\"range\" viewBox=\"0 0 320 20\" role=\"img\" aria-label=\"share that walked\">";
  out += rectangle("walks", 2.0, x(*share), 5.0, 10.0) +
         rectangle("falls", x(*share), 318.0, 5.0, 10.0);
  if (low && high)
    out += fmt::format("<path class=\"end\" d=\"M{0:.1f} 10H{1:.1f}M{0:.1f} 6v8M{1:.1f} 6v8\"/>",
                       x(*low), x(*high));
  return out + "</svg>";
}

}  // namespace legwright
