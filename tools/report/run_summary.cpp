// SPDX-License-Identifier: Apache-2.0
// A run in a screen of Markdown, as a comment on a pull request.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/attribution_words.hpp"
#include "tools/report/changed_parameters.hpp"
#include "tools/report/design_effect.hpp"
#include "tools/report/gap_view.hpp"
#include "tools/report/html.hpp"
#include "tools/report/judged_words.hpp"
#include "tools/report/number_words.hpp"
#include "tools/report/outer_words.hpp"
#include "tools/report/parameter_view.hpp"
#include "tools/report/report.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

// Rows of each table: all of them together stay below 60 lines.
constexpr std::size_t kMostFailing = 6, kMostFactors = 8, kMostParameters = 6, kMostEffects = 8;
constexpr std::size_t kLongest = 160;      // characters of a cell
constexpr std::size_t kLongestLine = 600;  // of a line of its own

/// Text from a file as a cell: nothing in it is markup, and it ends somewhere.
std::string cell(const std::string& text, std::size_t most = kLongest) {
  if (text.size() <= most) return escape_markdown(text);
  std::string head = text.substr(0, most);
  while (!head.empty() && (static_cast<unsigned char>(head.back()) & 0xC0) == 0x80) head.pop_back();
  if (!head.empty() && static_cast<unsigned char>(head.back()) >= 0xC0) head.pop_back();
  return escape_markdown(head) + "…";
}

std::string and_more(std::size_t all, std::size_t shown) {
  return all > shown ? fmt::format("\n… and {} more.\n", all - shown) : "";
}

std::string verdict_row(const RunData& data, Design design, const std::string& head) {
  const DesignVerdict* verdict = data.verdict_of(design);
  const std::string line = verdict == nullptr ? "" : verdict->line;
  const char* mark = verdict == nullptr ? "–" : verdict->pass ? "✅ PASS" : "❌ FAIL";
  const std::string words = !line.empty()     ? verdict_details(line)
                            : data.of_another ? kOfAnother
                                              : "not validated";
  return fmt::format("| {} | {} | {} |\n", head, mark, cell(words));
}

std::string home_touches(const RunData& data) {
  if (!data.verdict || !data.verdict->home_touches) return "";
  return "**Warning.** " + cell(data.verdict->home_touches->line, kLongestLine) + "\n\n";
}

std::string verdicts(const RunData& data) {
  const std::string head = "| | verdict | |\n|---|---|---|\n";
  if (motion_only(data))
    return head + verdict_row(data, Design::result, "initial body, only its gait optimised") + "\n";
  return head + verdict_row(data, Design::initial, "before: initial body, its gait optimised") +
         verdict_row(data, Design::result, "after: " + result_words(data.run)) + "\n" +
         home_touches(data);
}

std::string limits(const std::vector<LimitRow>& rows) {
  if (rows.empty()) return "";
  std::string out = fmt::format("**Limits.** {}\n\n", limits_kept(rows));
  std::size_t failing = 0;
  for (const LimitRow& row : rows) failing += row.pass ? 0 : 1;
  if (failing == 0) return out;
  out += "| limit not kept | measured | allowed | worst at |\n|---|---:|---:|---|\n";
  for (std::size_t k = 0; k < std::min(failing, kMostFailing); ++k) {
    const LimitRow& row = rows[k];
    out += fmt::format("| {} | {} | {} | {} |\n", cell(label_of(row)), cell(measured_words(row)),
                       cell(bound_words(row)), cell(row.where.empty() ? "–" : spaced(row.where)));
  }
  return out + and_more(failing, kMostFailing) + "\n";
}

std::string margins(const RunData& data) {
  std::string out;
  if (const std::string none = no_margins_words(data); !none.empty()) out += cell(none) + "\n\n";
  if (!data.factors().empty()) {
    out += "| margin | |\n|---|---|\n";
    for (std::size_t k = 0; k < std::min(data.factors().size(), kMostFactors); ++k) {
      const RobustnessFactor& factor = data.factors()[k];
      out += fmt::format("| {} | {} |\n", cell(label_of(factor)), cell(margin_words(factor)));
    }
    out += and_more(data.factors().size(), kMostFactors) + "\n";
  }
  const std::string survival = data.robustness ? survival_words(data.robustness->monte_carlo) : "";
  if (!survival.empty()) out += "**Everything off at once.** " + survival + "\n\n";
  const std::string numerics = data.numerics ? numerics_words(*data.numerics) : "";
  if (!numerics.empty()) out += "**Other numerics.** " + cell(numerics) + "\n";
  if (data.second_engine)
    out += "**Second engine.** " + cell(engine_words(*data.second_engine), kLongestLine) + "\n";
  if (data.strength)
    out += "**Printed parts.** " + cell(strength_words(*data.strength), kLongestLine) + "\n";
  if (!numerics.empty() || data.second_engine || data.strength) out += "\n";
  return out;
}

/// What the search knows to be wrong with the result, whether it was validated or not.
std::string infeasible(const RunRecord& run) {
  if (run.feasible.value_or(true) || !run.reasons || run.reasons->empty()) return "";
  std::string out = "**Infeasible.**\n";
  for (std::size_t k = 0; k < std::min(run.reasons->size(), kMostFailing); ++k)
    out += fmt::format("- {}\n", cell((*run.reasons)[k], kLongestLine));
  return out + and_more(run.reasons->size(), kMostFailing) + "\n";
}

std::string design_effect(const RunData& data) {
  const std::string words = effect_words(data);
  if (words.empty()) return "";
  std::string out =
      fmt::format("**What the {} bought.** {}\n\n", data.run.body_kept() ? "gait" : "body", words);
  out += "| | before | after | |\n|---|---:|---:|---:|\n";
  std::size_t shown = 0;
  for (const EffectRow& row : effect_rows(data)) {
    if (!row.effect.change || std::abs(*row.effect.change) < 5e-4 || shown == kMostEffects)
      continue;
    ++shown;
    out += fmt::format("| {} | {} | {} | {} |\n", cell(row.what), cell(row.before), cell(row.after),
                       change_words(*row.effect.change));
  }
  if (const std::string outer = outer_words(data); !outer.empty())
    out += "\n" + cell(outer, kLongestLine) + "\n";
  return out + "\n";
}

std::string closing(const RunData& data) {
  const auto gap = gap_of(data.run);
  if (!gap) return "";
  if (!gap->changed)
    return "**Closing the gap.** No step was confirmed to be better: the gait stays as it "
           "was.\n\n";
  return fmt::format(
      "**Closing the gap.** {}. Before: {}. Confirmed by MuJoCo, after: {}. F and the certificate "
      "are of the gait before.\n\n",
      cell(gap->factors), cell(gap->before.words), cell(gap->after.words));
}

std::string parameters(const RunData& data) {
  const ChangedParameters changed = changed_parameters(data.run);
  const std::vector<ChangedParameter>& all = changed.list;
  if (all.empty()) return "";
  std::string out = fmt::format("| {} | before | after | bounds |\n|---|---:|---:|---|\n",
                                changed.by_cost ? "buys most (F, put back alone)" : "changed most");
  for (std::size_t k = 0; k < std::min(all.size(), kMostParameters); ++k) {
    const ParameterView& p = all[k].view;
    std::string name = cell(spaced(p.name));
    if (changed.by_cost)
      name += std::isfinite(all[k].lowered) ? fmt::format(" ({})", change_of_cost(all[k].lowered))
                                            : " (no motion)";
    out += fmt::format("| {} | {} | {} | {} … {}{} |\n", name, p.with_unit(p.initial),
                       p.with_unit(p.final), p.with_unit(p.lower), p.with_unit(p.upper),
                       p.at_bound().empty() ? "" : ", at " + p.at_bound());
  }
  out += and_more(all.size(), kMostParameters) + "\n";
  const std::string few = fewest_words(data.run);
  return few.empty() ? out : out + cell(few, kLongestLine) + "\n\n";
}

}  // namespace

std::string told_sums(const RunData& data) {
  std::string out;
  for (const auto& [file, sum] : data.sums)
    if (file.ends_with("result/scene.xml"))
      out += fmt::format("{}`{}` (SHA-256 `{}`)", out.empty() ? "Of " : ", ", file, sum);
  const std::string* const limits =
      data.verdict && data.verdict->of ? data.verdict->of->find(kLimitsSum) : nullptr;
  if (limits != nullptr)
    out += fmt::format("{}limits (SHA-256 `{}`)", out.empty() ? "Of " : ", ", *limits);
  if (data.without_sums) out += out.empty() ? "Verdict without sums" : "; verdict without sums";
  return out.empty() ? out : out + ". ";
}

std::string report_summary(const RunData& data) {
  std::string out = fmt::format("# {}\n\n{}\n\n", cell(data.title), cell(task_words(data.run)));
  if (data.run.picked)
    out += fmt::format("Result picked by hand: {}.\n\n", cell(spaced(*data.run.picked)));
  out += verdicts(data) + limits(data.limits_of(Design::result)) + infeasible(data.run);
  if (motion_only(data)) {
    out += fmt::format("Cost F {}.\n\n", short_number(data.run.final_F));
  } else {
    out += fmt::format("Cost F from {} (gait alone) to {} ({}) in {} design iterations.\n\n",
                       short_number(data.run.motion_only_F), short_number(data.run.final_F),
                       data.run.body_kept() ? "the same body" : "co-designed",
                       short_number(data.run.design_iterations));
  }
  out += design_effect(data) + closing(data) + margins(data) + parameters(data);
  return out + told_sums(data) +
         "Pictures, charts and measurements: report.html in the folder above.\n";
}

}  // namespace legwright
