// SPDX-License-Identifier: Apache-2.0
// How far the world may differ from the model before the robot falls.
#include <fmt/format.h>

#include <algorithm>

#include "tools/report/sections.hpp"
#include "tools/report/svg_bars.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostWorst = 10, kMostCauses = 12;

void add_factor(Html& page, const RobustnessFactor& factor) {
  const ShownUnit unit = unit_of(factor);
  page.open("tr").open("td", {{"class", "head"}});
  page.element("b", factor.label.empty() ? spaced(factor.name) : factor.label);
  if (factor.nominal) page.element("small", "nominal " + unit.words(factor.nominal));
  page.close();
  page.open("td", {{"class", "margin"}});
  page.raw(
      range_bar({factor.tested_low, factor.tested_high, factor.low, factor.high, factor.nominal}));
  page.open("p", {{"class", "ends"}}).element("span", unit.words(factor.tested_low));
  page.element("span", unit.words(factor.tested_high)).close().close();
  page.open("td").element("b", margin_words(factor));
  if (factor.low && !factor.low_cause.empty()) page.element("small", "Below: " + factor.low_cause);
  if (factor.high && !factor.high_cause.empty())
    page.element("small", "Above: " + factor.high_cause);
  page.close().close();
}

/// A factor's value in a draw, by its label and in its unit where the factor is known.
std::string drawn_words(const std::vector<RobustnessFactor>& factors, const std::string& name,
                        double from, std::optional<double> to = std::nullopt) {
  const auto known = std::find_if(factors.begin(), factors.end(),
                                  [&](const RobustnessFactor& f) { return f.name == name; });
  const bool found = known != factors.end();
  const ShownUnit unit = found ? unit_of(*known) : ShownUnit{};
  const std::string label = found && !known->label.empty() ? known->label : spaced(name);
  return fmt::format("{} {}{}", label, unit.words(from), to ? " … " + unit.words(to) : "");
}

void add_worst(Html& page, const RunData& data, const Json& monte_carlo) {
  const Json& worst = value_at(monte_carlo, {"worst"});
  if (!worst.is_array() || worst.empty()) return;
  page.open("details").element("summary", "The draws that fell first");
  page.open("ul");
  for (std::size_t k = 0; k < std::min(worst.size(), kMostWorst); ++k) {
    const auto sample = number_at(worst[k], {"sample"});
    std::string out = text_at(worst[k], {"cause"});
    const Json& values = value_at(worst[k], {"values"});
    const char* separator = ": ";
    if (values.is_object()) {
      for (const auto& [name, value] : values.items()) {
        if (!value.is_number()) continue;
        out += fmt::format("{}{}", separator, drawn_words(data.factors, name, value.get<double>()));
        separator = "; ";
      }
    }
    page.open("li");
    if (sample) page.element("b", fmt::format("draw {:.0f}: ", *sample));
    page.text(out).close();
  }
  page.close().close();
}

void add_spread(Html& page, const RunData& data, const Json& monte_carlo) {
  const Json& spread = value_at(monte_carlo, {"spread"});
  if (!spread.is_object() || spread.empty()) return;
  std::string out;
  for (const auto& [name, range] : spread.items()) {
    if (!range.is_array() || range.size() != 2 || !range[0].is_number() || !range[1].is_number())
      continue;
    out += (out.empty() ? "" : "; ") +
           drawn_words(data.factors, name, range[0].get<double>(), range[1].get<double>());
  }
  if (!out.empty()) page.element("p", "Drawn at random: " + out + ".", {{"class", "note"}});
}

void add_causes(Html& page, const Json& monte_carlo) {
  const Json& causes = value_at(monte_carlo, {"causes"});
  if (!causes.is_object() || causes.empty()) return;
  page.open("ul", {{"class", "changes"}});
  std::size_t shown = 0;
  for (const auto& [cause, count] : causes.items()) {
    if (!count.is_number() || shown++ == kMostCauses) continue;
    page.element("li", fmt::format("{:.0f} × {}", count.get<double>(), cause));
  }
  page.close();
}

void add_survival(Html& page, const RunData& data, const Json& monte_carlo) {
  const std::string words = survival_words(monte_carlo);
  if (words.empty()) return;
  page.element("h3", "Everything off at once");
  page.open("div", {{"class", "survival"}});
  page.raw(share_bar(number_at(monte_carlo, {"share"}), number_at(monte_carlo, {"share_low"}),
                     number_at(monte_carlo, {"share_high"})));
  page.element("p", words).close();
  add_causes(page, monte_carlo);
  add_spread(page, data, monte_carlo);
  add_worst(page, data, monte_carlo);
}

}  // namespace

ShownUnit unit_of(const RobustnessFactor& factor) {
  return shown_unit(factor.unit,
                    std::max(std::abs(factor.tested_low), std::abs(factor.tested_high)));
}

std::string margin_words(const RobustnessFactor& factor) {
  const ShownUnit unit = unit_of(factor);
  if (!factor.low && !factor.high)
    return fmt::format("survives from {} to {}, all that was tried", unit.words(factor.tested_low),
                       unit.words(factor.tested_high));
  const auto side = [&](const std::optional<double>& value, const std::optional<double>& fails,
                        double tested, const char* beyond) {
    if (!value) return unit.words(tested) + beyond;
    return unit.words(value) +
           (fails == tested ? " (all tried but " + unit.words(tested) + ")" : "");
  };
  const std::string high = side(factor.high, factor.high_fails, factor.tested_high, " or more");
  const bool one_sided = factor.nominal && *factor.nominal <= factor.tested_low;
  if (!factor.low && one_sided) return "survives up to " + high;
  return fmt::format("survives from {} to {}",
                     side(factor.low, factor.low_fails, factor.tested_low, " or less"), high);
}

std::string no_margins_words(const Json& robustness) {
  const std::string cause = text_at(robustness, {"undisturbed_cause"});
  return cause.empty() ? "" : fmt::format("No margins: the gait fails undisturbed: {}.", cause);
}

std::string survival_words(const Json& monte_carlo) {
  const auto samples = number_at(monte_carlo, {"samples"}),
             survived = number_at(monte_carlo, {"survived"}),
             share = number_at(monte_carlo, {"share"}), low = number_at(monte_carlo, {"share_low"}),
             high = number_at(monte_carlo, {"share_high"});
  if (!samples || *samples < 1.0 || !survived || !share) return "";
  std::string out =
      fmt::format("{:.0f} of {:.0f} draws survived: {}", *survived, *samples, percent(share));
  if (low && high) out += fmt::format(" (95 % interval {} … {})", percent(low), percent(high));
  return out + ".";
}

void add_robustness(Html& page, const RunData& data) {
  page.open("section").element("h2", "Robustness: how much it bears");
  if (const std::string words = no_margins_words(data.robustness); !words.empty()) {
    page.element("p", words).close();
    return;
  }
  if (data.factors.empty() && value_at(data.robustness, {"monte_carlo"}).is_null()) {
    add_hint(page, "Nothing was varied yet.", "validate", data);
    page.close();
    return;
  }
  if (!data.factors.empty()) {
    page.element("p",
                 "One thing at a time is changed until the robot falls, or goes at less than half "
                 "or more than "
                 "twice the wanted speed; all else stays as the task says. To survive is less than "
                 "to pass the "
                 "verdict.",
                 {{"class", "note"}});
    page.raw(
        "<p class=\"legend\"><span><i class=\"key area b3\"></i>survives</span> <span><i "
        "class=\"key "
        "area bad-key\"></i>fails</span> <span><i class=\"key dot\"></i>nominal</span></p>\n");
    page.open("table", {{"class", "margins stack"}}).open("tbody");
    for (const RobustnessFactor& factor : data.factors) add_factor(page, factor);
    page.close().close();
  }
  add_survival(page, data, value_at(data.robustness, {"monte_carlo"}));
  page.close();
}

}  // namespace legwright
