// SPDX-License-Identifier: Apache-2.0
#include "tools/report/bought.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tools/report/changed_parameters.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr double kTiltThreshold = 0.01;   // [rad], for the worse
constexpr double kShareThreshold = 0.01;  // of the time, for the worse
constexpr const char* kSides[] = {"initial", "result"};

using Value = std::optional<double>;
using Sides = std::pair<Value, Value>;

/// One body's roll-outs, those that came to their end.
std::vector<const Json*> walks(const RunData& data, const char* side) {
  std::vector<const Json*> out;
  const Json& gains = value_at(data.metrics, {side});
  if (!gains.is_object()) return out;
  for (const auto& [gain, measured] : gains.items())
    if (measured.is_object() && value_at(measured, {"fall"}).is_null()) out.push_back(&measured);
  return out;
}

std::size_t falls(const RunData& data, const char* side) {
  const Json& gains = value_at(data.metrics, {side});
  std::size_t count = 0;
  if (!gains.is_object()) return 0;
  for (const auto& [gain, measured] : gains.items())
    count += value_at(measured, {"fall"}).is_object() ? 1 : 0;
  return count;
}

/// The least or greatest of the gains; none where the body falls at one of them.
Value over_gains(const RunData& data, const char* side, const char* key, bool greatest) {
  if (falls(data, side) > 0) return std::nullopt;
  Value out;
  for (const Json* measured : walks(data, side)) {
    const Value value = number_at(*measured, {key});
    if (!value) return std::nullopt;
    out = !out ? *value : greatest ? std::max(*out, *value) : std::min(*out, *value);
  }
  return out;
}

/// Of the roll-out at default gains, where it came to its end.
Value at_default(const RunData& data, const char* side,
                 const std::function<Value(const Json&)>& of) {
  const Json& measured = value_at(data.metrics, {side, "default"});
  if (!measured.is_object() || value_at(measured, {"fall"}).is_object()) return std::nullopt;
  return of(measured);
}

/// The greatest (or least) of one number over the entries of a list.
Value extreme(const Json& list, const char* key, bool greatest) {
  Value out;
  if (!list.is_array()) return out;
  for (const Json& entry : list) {
    const Value value = number_at(entry, {key});
    if (value) out = !out ? *value : greatest ? std::max(*out, *value) : std::min(*out, *value);
  }
  return out;
}

Value peak_torque(const Json& measured) {
  return extreme(value_at(measured, {"joints"}), "torque_peak_Nm", true);
}

Value least_clearance(const RunData& data, const char* side) {
  if (falls(data, side) > 0) return std::nullopt;
  Value out;
  for (const Json* measured : walks(data, side))
    if (const Value value = extreme(value_at(*measured, {"feet"}), "clearance_min_m", false))
      out = std::min(out.value_or(*value), *value);
  return out;
}

std::string verdict_words(const RunData& data, const char* side) {
  const Json& pass = value_at(data.verdict, {side, "pass"});
  if (!pass.is_boolean()) return "–";
  if (pass.get<bool>()) return "✓ passes";
  const std::size_t count = falls(data, side);
  return count == 0 ? "✗ fails" : fmt::format("✗ falls at {} of the gains", count);
}

class Rows {
 public:
  using Show = std::function<std::string(Value)>;
  void text(const char* what, std::string before, std::string after) {
    if (before == "–" && after == "–") return;
    rows_.push_back({what, std::move(before), std::move(after)});
  }
  /// @param least difference that is worth a word where it is for the worse
  void add(const std::string& what, const Sides& sides, const Show& show, Better better,
           double least = 0.0, bool amount = false) {
    if (!sides.first && !sides.second) return;
    rows_.push_back({what, show(sides.first), show(sides.second),
                     effect_of(sides.first, sides.second, better, least), amount});
  }
  /// The same of an amount: the less the better.
  void add_amount(const std::string& what, const Sides& sides, const Show& show) {
    add(what, sides, show, Better::less, 0.0, true);
  }
  std::vector<BoughtRow> take() { return std::move(rows_); }

 private:
  std::vector<BoughtRow> rows_;
};

Rows::Show in(const std::string& unit) {
  return [unit](Value value) { return amount_words(value, unit); };
}

Sides both(const std::function<Value(const char*)>& of) { return {of(kSides[0]), of(kSides[1])}; }

Sides outer_cost(const RunData& data) {
  if (!data.run.outer || data.iterations.empty()) return {};
  return {data.iterations.front().J, data.run.final_J};
}

void add_measured(const RunData& data, Rows& rows) {
  rows.text("in MuJoCo", verdict_words(data, kSides[0]), verdict_words(data, kSides[1]));
  const auto least = [&](const char* key) {
    return both([&](const char* side) { return over_gains(data, side, key, false); });
  };
  rows.add("of the wanted speed, worst gains", least("speed_ratio"), percent, Better::near_one);
  rows.add("of the wanted turn rate, worst gains", least("turn_ratio"), percent, Better::near_one);
  rows.add("largest tilt",
           both([&](const char* side) { return over_gains(data, side, "tilt_max_rad", true); }),
           in("rad"), Better::less, kTiltThreshold);
  rows.add("share of the time with a servo at its limit",
           both([&](const char* side) { return over_gains(data, side, "saturated_share", true); }),
           percent, Better::less, kShareThreshold);
  const auto standard = [&](const std::function<Value(const Json&)>& of) {
    return both([&](const char* side) { return at_default(data, side, of); });
  };
  const auto number = [](const char* key) {
    return [key](const Json& measured) { return number_at(measured, {key}); };
  };
  rows.add_amount("peak torque of a servo", standard(peak_torque), in("N m"));
  rows.add_amount("mechanical power", standard(number("power_mean_W")), in("W"));
  rows.add("cost of transport", standard(number("cost_of_transport")), short_number, Better::less);
  rows.add("steps over a bar of",
           both([&](const char* side) { return least_clearance(data, side); }), in("m"),
           data.run.task && data.run.task->step_over ? Better::more : Better::neither);
}

/// "31 % less mechanical power"
std::string amount_change(const BoughtRow& row) {
  return fmt::format("{} {} {}", percent_whole(std::abs(*row.effect.change)),
                     *row.effect.change < 0.0 ? "less" : "more", row.what);
}

std::string joined(const std::vector<std::string>& parts) {
  std::string out;
  for (std::size_t k = 0; k < parts.size(); ++k)
    out += (k == 0 ? "" : k + 1 == parts.size() ? " and " : ", ") + parts[k];
  return out;
}

/// What got less, and what got worse most of all: "25 % less mechanical power, but 22 % more printed volume".
/// Empty where neither is worth a word.
std::string balance(const std::vector<BoughtRow>& rows) {
  std::vector<Effect> effects;
  std::vector<bool> amounts;
  for (const BoughtRow& row : rows) {
    effects.push_back(row.effect);
    amounts.push_back(row.amount);
  }
  const MainEffects main = main_effects(effects, amounts);
  std::vector<std::string> gains;
  for (const std::size_t k : main.gains) gains.push_back(amount_change(rows[k]));
  const std::string gained = joined(gains);
  if (!main.worst) return gained;
  const BoughtRow& worst = rows[*main.worst];
  const std::string lost =
      worst.amount ? amount_change(worst)
                   : fmt::format("{} {} instead of {}", worst.what, worst.after, worst.before);
  return gained.empty() ? lost : gained + ", but " + lost;
}

/// Whether the weights of links go with their lengths; empty where no length changed.
std::string mass_words(const RunData& data, const ChangedParameters& changed) {
  if (std::none_of(changed.list.begin(), changed.list.end(),
                   [](const ChangedParameter& each) { return !each.view.angle; }))
    return "";
  if (!data.run.body) return "";
  return data.run.body->initial.printed_volume
             ? "Printed parts weigh more the longer they are; all others keep their mass."
             : "No part is printed, so links keep their mass however long they are.";
}

}  // namespace

std::string change_words(double change) {
  if (std::abs(change) < 5e-4) return "as before";
  const std::string size =
      std::abs(change) < 0.0995 ? percent(std::abs(change)) : percent_whole(std::abs(change));
  return fmt::format("{}{}", change < 0.0 ? "−" : "+", size);
}

std::vector<BoughtRow> bought_rows(const RunData& data) {
  Rows rows;
  if (!data.metrics.is_null()) add_measured(data, rows);
  if (const auto& body = data.run.body) {
    rows.add_amount("mass of the robot", {body->initial.mass, body->final.mass}, in("kg"));
    rows.add_amount("printed volume", {body->initial.printed_volume, body->final.printed_volume},
                    [](Value value) { return value ? short_number(*value * 1e6) + " cm³" : "–"; });
  }
  rows.add("cost of the gait, F", {data.run.motion_only_F, data.run.final_F}, short_number,
           Better::less);
  if (const Sides J = outer_cost(data); J.first || J.second)
    rows.add("what the body was to lower, " + spaced(data.run.outer->objective), J, short_number,
             Better::less);
  return rows.take();
}

std::string body_words(const RunData& data) {
  const ChangedParameters changed = changed_parameters(data.run);
  if (motion_only(data) || changed.list.empty()) return "";
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < changed.main_count; ++k) {
    const ParameterView& view = changed.list[k].view;
    parts.push_back(fmt::format("{} from {} to {}", spaced(view.name), view.with_unit(view.initial),
                                view.with_unit(view.final)));
  }
  std::string out =
      (changed.by_cost ? "What lowered the cost most: " : "Most of all ") + joined(parts) + ".";
  for (const std::string& more : {changed.bound_words(), mass_words(data, changed)})
    if (!more.empty()) out += " " + more;
  return out;
}

std::string bought_words(const RunData& data) {
  if (motion_only(data)) return "";
  const Json& before = value_at(data.verdict, {"initial", "pass"});
  const Json& after = value_at(data.verdict, {"result", "pass"});
  if (!before.is_boolean() || !after.is_boolean()) return "";
  const bool could = before.get<bool>(), can = after.get<bool>();
  const std::string more = balance(bought_rows(data));
  if (could && can)
    return more.empty()
               ? "Both bodies do the task in MuJoCo, with much the same effort."
               : "Both bodies do the task in MuJoCo; the co-designed one with " + more + ".";
  if (!could && can)
    return fmt::format(
        "The initial body with its own best gait does not do the task in MuJoCo, the co-designed "
        "one does{}.",
        more.empty() ? "" : ", with " + more);
  if (could)
    return "In MuJoCo the initial body does the task and the co-designed one does not: nothing was "
           "bought.";
  return "Neither body does the task in MuJoCo.";
}

}  // namespace legwright
