// SPDX-License-Identifier: Apache-2.0
// Numbers as people write them.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace legwright {

inline constexpr double kDegrees = 180.0 / std::numbers::pi;  // of a radian

/// The number, if it is one.
inline std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

inline std::optional<double> finite(std::optional<double> value) {
  return value ? finite(*value) : std::nullopt;
}

/// A number with so many decimals; "0" for what is below them.
std::string signed_text(double value, int digits);
/// Three significant digits, as a person would write them; "–" for none.
std::string short_number(std::optional<double> value);
/// The same with all three digits, for columns: "6.00".
std::string three_digits(std::optional<double> value);
/// Seven significant digits, for numbers that are to be compared with each other.
std::string long_number(std::optional<double> value);
/// A length in mm, an angle in degrees, anything else in its own unit ("N m" as "N·m").
std::string quantity_words(double amount, const std::string& unit);
/// A value times a factor with its unit behind it, as "2.5 mm" or "40°"; "–" for none.
std::string scaled(std::optional<double> value, double by, const char* unit);
std::string percent(std::optional<double> ratio);
/// The same without decimals.
std::string percent_whole(std::optional<double> ratio);
/// Of a relative change: "−31 %", "+4.2 %", "as before"; from ten times on "102 times", from a
/// thousand "from next to nothing".
std::string change_words(double change);

/// The unit in which people read a quantity: mm for short lengths, ms for short times, degrees.
struct ShownUnit {
  double scale = 1.0;
  std::string name;  // empty for a plain number
  /// "2.5 mm", "40°"; "–" for none.
  std::string words(std::optional<double> value) const;
};
/// @param unit SI, "1" or empty for none @param largest of the values that are to be shown together
ShownUnit shown_unit(const std::string& unit, double largest);
/// A value in the unit in which people read it; "–" for none.
std::string amount_words(std::optional<double> value, const std::string& unit);
/// The same, and a share as a percentage where the unit is "%".
std::string percent_or_amount(std::optional<double> value, const std::string& unit);
/// An error in time [s] by its direction: "17 ms early", "4.2 ms late", "on time"; "–" for none.
std::string early_or_late(std::optional<double> error);

}  // namespace legwright
