// SPDX-License-Identifier: Apache-2.0
#include "tools/report/number_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

/// `size` with `digits` significant ones; far from one as "1.3 × 10⁻⁷".
std::string digits_of(double size, int digits) {
  if (size >= 1e6 || size < 1e-3) {
    const std::string text = fmt::format("{:.{}e}", size, digits - 1);
    const std::size_t e = text.find('e');
    std::string power;
    static constexpr const char* kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    for (const char c : text.substr(e + 1)) {
      if (c == '-') power += "⁻";
      if (c >= '0' && c <= '9' && !(c == '0' && (power.empty() || power == "⁻")))
        power += kRaised[c - '0'];
    }
    return fmt::format("{} × 10{}", text.substr(0, e), power);
  }
  const int magnitude = static_cast<int>(std::floor(std::log10(size)));
  return fmt::format("{:.{}f}", size, std::max(0, digits - 1 - magnitude));
}

}  // namespace

std::string signed_text(double value, int digits) {
  const std::string text = fmt::format("{:.{}f}", std::abs(value), digits);
  if (text.find_first_not_of("0.") == std::string::npos) return "0";
  return (value < 0 ? "−" : "") + text;
}

std::string short_number(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return "–";
  if (*value == 0.0) return "0";
  const double size = std::abs(*value);
  const std::string sign = *value < 0 ? "−" : "";
  if (size >= 1e6 || size < 1e-3) return sign + digits_of(size, 2);
  std::string text = digits_of(size, 3);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return sign + text;
}

std::string three_digits(std::optional<double> value) {
  if (!value || !std::isfinite(*value) || *value == 0.0) return short_number(value);
  return fmt::format("{}{}", *value < 0 ? "−" : "", digits_of(std::abs(*value), 3));
}

std::string long_number(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return "–";
  if (*value == 0.0) return "0";
  return fmt::format("{}{}", *value < 0 ? "−" : "", digits_of(std::abs(*value), 7));
}

std::string quantity_words(double amount, const std::string& unit) {
  const bool length = unit == "m", angle = unit == "rad";
  const double shown = std::abs(amount) * (length ? 1e3 : angle ? kDegrees : 1.0);
  const char* sign = amount < 0.0 ? "−" : "";
  std::string text =
      shown > 0.0 && shown < 1e-3 ? "below 0.001" : fmt::format("{}{}", sign, short_number(shown));
  if (length) return text + " mm";
  if (angle) return text + "°";
  if (unit.empty()) return text;
  return fmt::format("{} {}", text, unit == "N m" ? "N·m" : unit);
}

std::string scaled(std::optional<double> value, double by, const char* unit) {
  return value && std::isfinite(*value) ? short_number(*value * by) + unit : "–";
}

std::string percent(std::optional<double> ratio) {
  return ratio && std::isfinite(*ratio) ? fmt::format("{} %", signed_text(100.0 * *ratio, 1)) : "–";
}

std::string percent_whole(std::optional<double> ratio) {
  return ratio && std::isfinite(*ratio) ? fmt::format("{} %", signed_text(100.0 * *ratio, 0)) : "–";
}

std::string change_words(double change) {
  if (std::abs(change) < 5e-4) return "as before";
  if (1.0 + change > 999.0) return "from next to nothing";
  if (change >= 9.0) return short_number(1.0 + change) + " times";
  const std::string size =
      std::abs(change) < 0.0995 ? percent(std::abs(change)) : percent_whole(std::abs(change));
  return fmt::format("{}{}", change < 0.0 ? "−" : "+", size);
}

std::string ShownUnit::words(std::optional<double> value) const {
  if (!value || !std::isfinite(*value)) return "–";
  const double shown = *value * scale;
  // Below a millionth of what is measured here there is only noise.
  const std::string text = std::abs(shown) < 1e-6 ? "0" : short_number(shown);
  return name.empty() ? text : name == "°" ? text + name : text + " " + name;
}

ShownUnit shown_unit(const std::string& unit, double largest) {
  if (unit == "m" && largest < 1.0) return {1e3, "mm"};
  if (unit == "s" && largest < 0.5) return {1e3, "ms"};
  if (unit == "rad") return {kDegrees, "°"};
  if (unit == "1") return {};
  std::string name = unit;
  for (std::size_t at = name.find(' '); at != std::string::npos; at = name.find(' '))
    name.replace(at, 1, "·");
  return {1.0, name};
}

std::string amount_words(std::optional<double> value, const std::string& unit) {
  return shown_unit(unit, std::abs(value.value_or(0.0))).words(value);
}

std::string percent_or_amount(std::optional<double> value, const std::string& unit) {
  return unit == "%" ? percent(value) : amount_words(value, unit);
}

std::string early_or_late(std::optional<double> error) {
  if (!error || !std::isfinite(*error)) return "–";
  const ShownUnit unit = shown_unit("s", std::abs(*error));
  const std::string size = unit.words(std::abs(*error));
  if (size == unit.words(0.0)) return "on time";
  return size + (*error < 0.0 ? " early" : " late");
}

}  // namespace legwright
