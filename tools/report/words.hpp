// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/report/run_data.hpp"

namespace legwright {

inline constexpr double kDegrees = 180.0 / std::numbers::pi;  // of a radian

/// "front_hip_axis_yaw" → "front hip axis yaw".
std::string spaced(std::string_view name);
/// The first row of that name; null without.
template <class Row>
const Row* find_named(const std::vector<Row>& rows, const std::string& name) {
  for (const Row& row : rows)
    if (row.name == name) return &row;
  return nullptr;
}
/// What a factor or a run of numerics is called; its name, spaced, where it has no label.
template <class Row>
std::string label_of(const Row& row) {
  return row.label.empty() ? spaced(row.name) : row.label;
}
/// The same of a limit.
inline std::string label_of(const LimitRow& row) {
  return row.what.empty() ? spaced(row.name) : row.what;
}
/// A verdict's line without what stands before its first colon, which a mark beside it says.
std::string verdict_details(const std::string& line);
/// Robot and task of a run; never empty.
std::string title_of(const RunData& data);
/// A term of F in a few words; its own name, spaced, where it is not known here.
std::string term_words(const std::string& name);
/// What a term of F punishes, as a noun: "slip of stance feet"; its own name, spaced, where it is
/// not known here.
std::string cost_words(const std::string& name);
/// What the task asks for: "walk, 0.1 m/s to the left, period 1 s".
std::string task_words(const RunRecord& run);
/// The same of a run.json's "task" or of one of its "tasks".
std::string way_words(const TaskRecord& task);
/// Three significant digits, as a person would write them; "–" for none.
std::string short_number(std::optional<double> value);
/// The same with all three digits, for columns: "6.00".
std::string three_digits(std::optional<double> value);
/// Seven significant digits, for numbers that are to be compared with each other.
std::string long_number(std::optional<double> value);
/// A length in mm, an angle in degrees, anything else in its own unit ("N m" as "N·m").
std::string quantity_words(double amount, const std::string& unit);
std::string percent(std::optional<double> ratio);
/// The same without decimals.
std::string percent_whole(std::optional<double> ratio);

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

/// A design parameter as run.json has it, in the units people think in.
struct ParameterView {
  std::string name, sentence;
  bool angle = false;
  double initial = 0.0, final = 0.0, lower = 0.0, upper = 0.0;  // SI
  /// mm or degrees
  double shown(double value) const;
  std::string with_unit(double value) const;
  std::string in_radian(double value) const;
  std::string change() const;
  double share_of_range() const;
  /// "lower bound", "upper bound" or nothing.
  std::string at_bound() const;
  /// The same for another value.
  std::string bound_of(double value) const;
};
std::vector<ParameterView> parameters_of(const RunRecord& run);

}  // namespace legwright
