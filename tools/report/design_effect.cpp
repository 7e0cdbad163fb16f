// SPDX-License-Identifier: Apache-2.0
#include "tools/report/design_effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tools/report/changed_parameters.hpp"
#include "tools/report/number_words.hpp"
#include "tools/report/outer_words.hpp"
#include "tools/report/parameter_view.hpp"
#include "tools/report/words.hpp"
#include "tools/run/joined_by_and.hpp"

namespace legwright {
namespace {

constexpr double kTiltThreshold = 0.01;   // [rad], for the worse
constexpr double kShareThreshold = 0.01;  // of the time, for the worse

using Value = std::optional<double>;
using Sides = std::pair<Value, Value>;

std::size_t falls(const ByName<GainMetrics>& gains) {
  return static_cast<std::size_t>(std::count_if(
      gains.begin(), gains.end(), [](const auto& gain) { return gain.second.fall.has_value(); }));
}

/// The least or greatest of two numbers, either of which may be none.
void take(Value& out, Value value, bool greatest) {
  if (value) out = !out ? *value : greatest ? std::max(*out, *value) : std::min(*out, *value);
}

/// The least or greatest of the gains; none where the body falls at one of them, or where one has
/// no such number.
template <class Member>
Value over_gains(const ByName<GainMetrics>& gains, Member member, bool greatest) {
  if (falls(gains) > 0) return std::nullopt;
  Value out;
  for (const auto& [gain, measured] : gains) {
    const Value value = finite(measured.*member);
    if (!value) return std::nullopt;
    take(out, value, greatest);
  }
  return out;
}

/// Of the roll-out at default gains, where it came to its end.
Value at_default(const ByName<GainMetrics>& gains,
                 const std::function<Value(const GainMetrics&)>& of) {
  const GainMetrics* measured = gains.find("default");
  return measured == nullptr || measured->fall ? std::nullopt : of(*measured);
}

Value peak_torque(const GainMetrics& measured) {
  Value out;
  for (const JointMetrics& joint : measured.joints) take(out, finite(joint.torque_peak), true);
  return out;
}

Value least_clearance(const ByName<GainMetrics>& gains) {
  if (falls(gains) > 0) return std::nullopt;
  Value out;
  for (const auto& [gain, measured] : gains)
    for (const FootMetrics& foot : measured.feet) take(out, finite(foot.clearance_min), false);
  return out;
}

std::string verdict_words(const RunData& data, Design design) {
  const DesignVerdict* verdict = data.verdict_of(design);
  if (verdict == nullptr) return "–";
  if (verdict->pass) return "✓ passes";
  const std::size_t count = falls(data.gains_of(design));
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
  std::vector<EffectRow> take() { return std::move(rows_); }

 private:
  std::vector<EffectRow> rows_;
};

Rows::Show in(const std::string& unit) {
  return [unit](Value value) { return amount_words(value, unit); };
}

Sides outer_amounts(const RunData& data) {
  if (!data.run.outer) return {};
  return {data.run.outer->plan_initial, data.run.outer->plan_final};
}

void add_measured(const RunData& data, Rows& rows) {
  const auto both = [&](const auto& of) {
    return Sides{of(data.gains_of(Design::initial)), of(data.gains_of(Design::result))};
  };
  const auto worst = [&](auto member, bool greatest) {
    return both([=](const auto& gains) { return over_gains(gains, member, greatest); });
  };
  const auto standard = [&](const auto& of) {
    return both([&](const auto& gains) { return at_default(gains, of); });
  };
  using M = GainMetrics;
  rows.text("in MuJoCo", verdict_words(data, Design::initial), verdict_words(data, Design::result));
  rows.add("of the wanted speed, worst gains", worst(&M::speed_ratio, false), percent,
           Better::near_one);
  rows.add("of the wanted turn rate, worst gains", worst(&M::turn_ratio, false), percent,
           Better::near_one);
  rows.add("largest tilt", worst(&M::tilt_max, true), in("rad"), Better::less, kTiltThreshold);
  rows.add("share of the time with a servo at its limit", worst(&M::saturated_share, true), percent,
           Better::less, kShareThreshold);
  rows.add_amount("peak torque of a servo", standard(peak_torque), in("N m"));
  rows.add_amount("mechanical power", standard([](const M& m) { return m.power_mean; }), in("W"));
  rows.add("cost of transport", standard([](const M& m) { return m.cost_of_transport; }),
           short_number, Better::less);
  rows.add("steps over a bar of", both(least_clearance), in("m"),
           data.run.task && data.run.task->step_over ? Better::more : Better::neither);
}

/// "31 % less mechanical power"
std::string amount_change(const EffectRow& row) {
  return fmt::format("{} {} {}", percent_whole(std::abs(*row.effect.change)),
                     *row.effect.change < 0.0 ? "less" : "more", row.what);
}

/// What got less, and what got worse most of all: "25 % less mechanical power, but 22 % more
/// printed volume". Empty where neither is worth a word.
std::string balance(const std::vector<EffectRow>& rows) {
  std::vector<Effect> effects;
  std::vector<bool> amounts;
  for (const EffectRow& row : rows) {
    effects.push_back(row.effect);
    amounts.push_back(row.amount);
  }
  const MainEffects main = main_effects(effects, amounts);
  std::vector<std::string> gains;
  for (const std::size_t k : main.gains) gains.push_back(amount_change(rows[k]));
  std::string gained = joined_by_and(gains);
  if (!main.worst) return gained;
  const EffectRow& worst = rows[*main.worst];
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

std::vector<EffectRow> effect_rows(const RunData& data) {
  Rows rows;
  if (data.metrics) add_measured(data, rows);
  if (const auto& body = data.run.body) {
    rows.add_amount("mass of the robot", {body->initial.mass, body->final.mass}, in("kg"));
    rows.add_amount("printed volume", {body->initial.printed_volume, body->final.printed_volume},
                    [](Value value) { return value ? short_number(*value * 1e6) + " cm³" : "–"; });
  }
  rows.add("cost of the gait, F", {data.run.motion_only_F, data.run.final_F}, short_number,
           Better::less);
  if (const Sides plans = outer_amounts(data); plans.first || plans.second)
    rows.add(
        "in the plan: " + spaced(data.run.outer->objective), plans,
        [&](Value value) { return outer_amount_words(*data.run.outer, value); }, Better::less);
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
      (changed.by_cost ? "What buys most: " : "Most of all ") + joined_by_and(parts) + ".";
  for (const std::string& more : {changed.bound_words(), mass_words(data, changed)})
    if (!more.empty()) out += " " + more;
  return out;
}

std::string effect_words(const RunData& data) {
  if (motion_only(data)) return "";
  if (!data.verdict) return "";
  const bool could = data.verdict->initial.pass, can = data.verdict->result.pass;
  const std::string more = balance(effect_rows(data));
  if (data.run.body_kept())
    return can ? std::string("The body stays as it is: it does the task in MuJoCo") +
                     (could ? "." : " once its gait is tightened.")
               : "The body stays as it is, and does not do the task in MuJoCo.";
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
