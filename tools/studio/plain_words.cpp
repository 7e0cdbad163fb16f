// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/plain_words.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <string_view>

namespace legwright {
namespace {

struct PlainRow {
  std::string_view name, words;
  bool percent = false;  // told in %
};

constexpr std::array<PlainRow, 25> kPlain{{
    {"saturated_share", "time with a servo at its torque limit", true},
    {"self_contact", "time in which the robot touches itself", true},
    {"self_contact_depth", "how deep parts of the robot go into each other"},
    {"speed_ratio", "speed, of the planned one", true},
    {"standing_speed", "speed where it should stay in its place"},
    {"turn_ratio", "turn rate, of the planned one", true},
    {"radius_ratio", "radius of its circle, of the planned one", true},
    {"tilt", "largest tilt of the trunk"},
    {"heading_drift_per_cycle", "turned off its heading, each cycle"},
    {"path_deviation", "off the wanted path, of the way walked", true},
    {"slowest_cycle", "speed in the slowest cycle, of the planned one", true},
    {"heading_drift", "turned off its heading, in all"},
    {"lateral_drift", "speed across the wanted direction"},
    {"slip", "longest slip of a foot in one stance"},
    {"touchdown_error", "touchdown too early or too late, at most"},
    {"liftoff_error", "lift-off too early or too late, at most"},
    {"landing_speed", "fastest landing of a foot"},
    {"foot_clearance", "height of a bar that every foot steps over"},
    {"missed_stances", "steps in which a foot never touched the ground"},
    {"tracking", "joints off their targets, on average (RMS)"},
    {"torque_peak_share", "highest torque of a servo, of its limit", true},
    {"torque_rms", "torque of the servos, on average (RMS)"},
    {"power", "power of the servos, on average"},
    {"cost_of_transport", "power for weight and speed (cost of transport)"},
    {"penetration", "how deep a foot sinks into the ground"},
}};

const PlainRow* find_plain(const std::string& name) {
  for (const PlainRow& row : kPlain)
    if (row.name == name) return &row;
  return nullptr;
}

std::string with_unit(const LimitRow& row, double value) {
  const PlainRow* const plain = find_plain(row.name);
  if (plain && plain->percent) return fmt::format("{:.3g} %", 100.0 * value);
  const bool bare = row.unit == "1" || row.unit.empty();
  std::string words = fmt::format("{:.3g}{}{}", value, bare ? "" : " ", bare ? "" : row.unit);
  if (row.unit == "rad") words += fmt::format(" ({:.2g}°)", value * 180.0 / std::numbers::pi);
  return words;
}

}  // namespace

std::string plain_name_of(const LimitRow& row) {
  const PlainRow* const plain = find_plain(row.name);
  return plain ? std::string(plain->words) : row.what;
}

std::string plain_value_of(const LimitRow& row) {
  return plain_name_of(row) + ": " +
         (row.value ? with_unit(row, *row.value) : std::string("could not be measured"));
}

std::string plain_words_of(const LimitRow& row) {
  const auto told = [&](double value) { return with_unit(row, value); };
  std::string words = plain_value_of(row);
  if (!row.where.empty()) words += " at " + row.where;
  if (row.low && row.high)
    return words + " (" + told(*row.low) + " to " + told(*row.high) + " passes)";
  if (row.high) return words + " (at most " + told(*row.high) + ")";
  if (row.low) return words + " (at least " + told(*row.low) + ")";
  return words;
}

std::string term_of(const LimitRow& row) { return row.name + ": " + row.what; }

}  // namespace legwright
