// SPDX-License-Identifier: Apache-2.0
#include "tools/report/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "optimizer/terms/registry.hpp"

namespace legwright {
namespace {

std::string signed_text(double value, int digits) {
  const std::string text = fmt::format("{:.{}f}", std::abs(value), digits);
  if (text.find_first_not_of("0.") == std::string::npos) return "0";
  return (value < 0 ? "−" : "") + text;
}

}  // namespace

std::string spaced(std::string_view name) {
  std::string out(name);
  std::replace(out.begin(), out.end(), '_', ' ');
  return out;
}

std::string verdict_details(const std::string& line) {
  const std::size_t colon = line.find(": ");
  return colon == std::string::npos ? line : line.substr(colon + 2);
}

std::string title_of(const RunData& data) {
  const std::string &robot = data.run.robot, task = data.run.task ? data.run.task->name : "";
  const std::string title = robot.empty()  ? task
                            : task.empty() ? robot
                                           : robot + " · " + spaced(task);
  return title.empty() ? "Legwright run" : title;
}

std::string term_words(const std::string& name) {
  const TermEntry* term = find_term(name);
  return term != nullptr ? std::string(term->label) : spaced(name);
}

std::string cost_words(const std::string& name) {
  const TermEntry* term = find_term(name);
  return term != nullptr ? std::string(term->cost_label) : spaced(name);
}

std::string task_words(const RunRecord& run) { return run.task ? way_words(*run.task) : ""; }

namespace {

/// ", up a slope of 8°, carrying 0.5 kg", …
std::string demand_words(const TaskRecord& task) {
  std::string out;
  const SlopeRecord slope = task.slope.value_or(SlopeRecord{});
  if (slope.along != 0.0)
    out += fmt::format(", {} a slope of {}", slope.along > 0.0 ? "up" : "down",
                       quantity_words(std::abs(slope.along), "rad"));
  if (slope.across != 0.0)
    out += fmt::format(", across a slope of {}", quantity_words(std::abs(slope.across), "rad"));
  if (task.payload) out += fmt::format(", carrying {} kg", short_number(task.payload->mass));
  if (task.step_over) out += ", stepping over " + quantity_words(*task.step_over, "m");
  if (task.torque_limit) out += ", with motors of " + quantity_words(*task.torque_limit, "N m");
  if (task.servo_kp)
    out += fmt::format(", servos as stiff as {} N m/rad or as their torque limits bear",
                       short_number(task.servo_kp));
  return out;
}

}  // namespace

std::string way_words(const TaskRecord& task) {
  std::string out = task.gait;
  const auto part = [&](double speed, const char* ahead, const char* back) {
    if (speed != 0.0)
      out += fmt::format("{}{} m/s {}", out.empty() ? "" : ", ", short_number(std::abs(speed)),
                         speed > 0 ? ahead : back);
  };
  part(task.velocity[0], "forward", "backward");
  part(task.velocity[1], "to the left", "to the right");
  if (task.turn_rate != 0.0) out += fmt::format(", turning {} rad/s", short_number(task.turn_rate));
  return out + demand_words(task) + fmt::format(", {} s per cycle", short_number(task.period));
}

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

std::string percent(std::optional<double> ratio) {
  return ratio && std::isfinite(*ratio) ? fmt::format("{} %", signed_text(100.0 * *ratio, 1)) : "–";
}

std::string percent_whole(std::optional<double> ratio) {
  return ratio && std::isfinite(*ratio) ? fmt::format("{} %", signed_text(100.0 * *ratio, 0)) : "–";
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

double ParameterView::shown(double value) const {
  return angle ? value * 180.0 / std::numbers::pi : value * 1000.0;
}

std::string ParameterView::with_unit(double value) const {
  return signed_text(shown(value), 1) + (angle ? "°" : " mm");
}

std::string ParameterView::in_radian(double value) const { return signed_text(value, 3) + " rad"; }

std::string ParameterView::change() const {
  const double by = final - initial;
  const std::string text = with_unit(by);
  if (text.front() == '0' && text.find_first_of("123456789") == std::string::npos) return "0";
  return by > 0 ? "+" + text : text;
}

double ParameterView::share_of_range() const {
  return upper > lower ? std::abs(final - initial) / (upper - lower) : 0.0;
}

std::string ParameterView::at_bound() const { return bound_of(final); }

std::string ParameterView::bound_of(double value) const {
  const double close = 1e-6 * (upper - lower);
  return value <= lower + close ? "lower bound" : value >= upper - close ? "upper bound" : "";
}

std::vector<ParameterView> parameters_of(const RunRecord& run) {
  std::vector<ParameterView> views;
  for (const ParameterRecord& p : run.parameters)
    views.push_back({p.name, p.sentence, p.unit == "rad", p.initial, p.final, p.lower, p.upper});
  return views;
}

}  // namespace legwright
