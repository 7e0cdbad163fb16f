// SPDX-License-Identifier: Apache-2.0
// How far the world may differ from the model before the robot falls.
#include <fmt/format.h>

#include <algorithm>

#include "tools/report/judged_words.hpp"
#include "tools/report/number_words.hpp"
#include "tools/report/page_template.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/svg_bars.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostWorst = 10, kMostCauses = 12;

/// Why it fails beyond a margin. @param where "Below: "
std::string cause_html(const std::optional<double>& margin, const std::optional<std::string>& cause,
                       const char* where) {
  return margin && cause ? small_html(where + *cause) : "";
}

std::string factor_html(const RobustnessFactor& factor) {
  const ShownUnit unit = unit_of(factor);
  const auto nominal = finite(factor.nominal);
  return fill(R"(<tr><td class="head"><b>{label}</b>{nominal}</td>
<td class="margin">{bar}<p class="ends"><span>{from}</span><span>{to}</span></p></td>
<td><b>{margin}</b>{below}{above}</td></tr>
)",
              {{"label", label_of(factor)},
               Hole::markup("nominal", nominal ? small_html("nominal " + unit.words(nominal)) : ""),
               Hole::markup("bar", range_bar({factor.tested_low, factor.tested_high, factor.low,
                                              factor.high, nominal})),
               {"from", unit.words(factor.tested_low)},
               {"to", unit.words(factor.tested_high)},
               {"margin", margin_words(factor)},
               Hole::markup("below", cause_html(factor.low, factor.low_cause, "Below: ")),
               Hole::markup("above", cause_html(factor.high, factor.high_cause, "Above: "))});
}

/// A factor's value in a draw, by its label and in its unit where the factor is known.
std::string drawn_words(const std::vector<RobustnessFactor>& factors, const std::string& name,
                        double from, std::optional<double> to = std::nullopt) {
  const RobustnessFactor* const known = find_named(factors, name);
  const ShownUnit unit = known ? unit_of(*known) : ShownUnit{};
  const std::string label = known ? label_of(*known) : spaced(name);
  return fmt::format("{} {}{}", label, unit.words(from), to ? " … " + unit.words(to) : "");
}

std::string draw_html(const std::vector<RobustnessFactor>& factors, const FailedDraw& draw) {
  std::string words = draw.cause;
  const char* separator = ": ";
  for (const auto& [name, value] : draw.values) {
    words += separator + drawn_words(factors, name, value);
    separator = "; ";
  }
  return fill("<li><b>draw {sample}: </b>{words}</li>\n",
              {{"sample", std::to_string(draw.sample)}, {"words", words}});
}

std::string worst_html(const std::vector<RobustnessFactor>& factors, const MonteCarlo& drawn) {
  if (drawn.worst.empty()) return "";
  const std::vector<FailedDraw> worst(
      drawn.worst.begin(),
      drawn.worst.begin() + static_cast<std::ptrdiff_t>(std::min(drawn.worst.size(), kMostWorst)));
  return fill("<details><summary>The draws that fell first</summary><ul>\n{draws}</ul></details>\n",
              {Hole::markup("draws", each(worst, [&](const FailedDraw& draw) {
                              return draw_html(factors, draw);
                            }))});
}

std::string spread_html(const std::vector<RobustnessFactor>& factors, const MonteCarlo& drawn) {
  std::string words;
  for (const auto& [name, range] : drawn.spread)
    words += (words.empty() ? "" : "; ") + drawn_words(factors, name, range.first, range.second);
  return words.empty()
             ? ""
             : fill("<p class=\"note\">Drawn at random: {words}.</p>\n", {{"words", words}});
}

std::string causes_html(const MonteCarlo& drawn) {
  std::string rows;
  std::size_t shown = 0;
  for (const auto& [cause, count] : drawn.causes)
    if (shown++ < kMostCauses)
      rows += fill("<li>{count} × {cause}</li>\n",
                   {{"count", std::to_string(count)}, {"cause", cause}});
  return rows.empty() ? "" : "<ul class=\"changes\">\n" + rows + "</ul>\n";
}

std::string survival_html(const std::vector<RobustnessFactor>& factors, const MonteCarlo& drawn) {
  const std::string words = survival_words(drawn);
  if (words.empty()) return "";
  return fill(R"(<h3>Everything off at once</h3>
<div class="survival">{bar}<p>{words}</p></div>
{causes}{spread}{worst})",
              {Hole::markup("bar", share_bar(finite(drawn.share), finite(drawn.share_low),
                                             finite(drawn.share_high))),
               {"words", words},
               Hole::markup("causes", causes_html(drawn)),
               Hole::markup("spread", spread_html(factors, drawn)),
               Hole::markup("worst", worst_html(factors, drawn))});
}

}  // namespace

void add_robustness(Html& page, const RunData& data) {
  page.open("section").element("h2", "Robustness: how much it bears");
  if (const std::string words = no_margins_words(data); !words.empty()) {
    page.element("p", words).close();
    return;
  }
  if (!data.robustness) {
    add_hint(page, "Nothing was varied yet.", "validate", data);
    page.close();
    return;
  }
  const auto& factors = data.robustness->factors;
  if (!factors.empty())
    page.raw(fill(
        R"(<p class="note">One thing at a time is changed until the robot falls, or goes at less than half or more than
twice the wanted speed; all else stays as the task says. To survive is less than to pass the
verdict.</p>
<p class="legend"><span><i class="key area b3"></i>survives</span> <span><i class="key
area bad-key"></i>fails</span> <span><i class="key dot"></i>nominal</span></p>
<table class="margins stack"><tbody>
{rows}</tbody></table>
)",
        {Hole::markup("rows", each(factors, factor_html))}));
  page.raw(survival_html(factors, data.robustness->monte_carlo)).close();
}

}  // namespace legwright
