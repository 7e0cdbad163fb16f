// SPDX-License-Identifier: Apache-2.0
// With how few changes of the body F falls how far: a paragraph and a chart.
#include <fmt/format.h>

#include <algorithm>

#include "tools/report/sections.hpp"
#include "tools/report/svg_plot.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

PlotSeries passing_bodies(const FewestChangesRecord& fewest) {
  PlotSeries out;
  out.name = "passes in MuJoCo";
  out.colour = 2;
  out.mark = true;
  for (const FewerChangesRecord& design : fewest.designs) {
    if (!design.played || !design.played->pass) continue;
    out.x.push_back(static_cast<double>(design.changed.size()));
    out.y.push_back(design.F);
  }
  return out;
}

/// " MuJoCo passes 3 of these 9 bodies for a few cycles, of which the least changed has 5 changes."
std::string physics_words(const FewestChangesRecord& fewest) {
  const auto played = std::count_if(fewest.designs.begin(), fewest.designs.end(),
                                    [](const auto& design) { return design.played.has_value(); });
  if (played == 0) return "";
  const FewerChangesRecord* const least = least_that_passes(fewest);
  if (least == nullptr)
    return fmt::format(" MuJoCo passes none of these {} bodies for a few cycles.", played);
  const std::size_t count = least->changed.size();
  return fmt::format(
      " MuJoCo passes {} of these {} bodies for a few cycles, of which the least changed has {} "
      "change{}.",
      passing_bodies(fewest).x.size(), played, count, count == 1 ? "" : "s");
}

std::string fewest_chart(const FewestChangesRecord& fewest) {
  PlotSeries cost;
  cost.name = "F";
  cost.points = true;
  cost.x.push_back(0.0);
  cost.y.push_back(fewest.initial_F);
  for (std::size_t k = fewest.designs.size(); k-- > 0;) {
    cost.x.push_back(static_cast<double>(fewest.designs[k].changed.size()));
    cost.y.push_back(fewest.designs[k].F);
  }
  const double least = fewest.designs.front().F;
  PlotSeries kept;
  kept.name = fmt::format("{} of the fall", percent_whole(fewest.share));
  kept.colour = 3;
  kept.dashed = true;
  kept.x = {0.0, cost.x.back()};
  kept.y.assign(2, fewest.initial_F - fewest.share * (fewest.initial_F - least));
  PlotOptions options;
  options.title = "F by number of changed parameters";
  options.x_label = "changed parameters (0: initial body)";
  options.y_label = "log scale";
  options.log_y = true;
  options.whole_x = true;
  options.height = 200;
  return line_plot({cost, kept, passing_bodies(fewest)}, options);
}

}  // namespace

std::string fewest_words(const RunRecord& run) {
  if (!run.fewest_changes || run.fewest_changes->designs.empty()) return "";
  const FewestChangesRecord& fewest = *run.fewest_changes;
  if (fewest.fewest >= fewest.designs.size()) return "";
  const FewerChangesRecord &all = fewest.designs.front(), &few = fewest.designs[fewest.fewest];
  const std::size_t count = few.changed.size();
  const double fall = fewest.initial_F - all.F;
  if (!(fall > 0.0)) return "";
  std::string out =
      fmt::format("{} of {} changes {} {} of the fall of F (F {} instead of {}; {} without any)",
                  count, all.changed.size(), count == 1 ? "buys" : "buy",
                  percent_whole((fewest.initial_F - few.F) / fall), short_number(few.F),
                  short_number(all.F), short_number(fewest.initial_F));
  out += named_if_few(few.changed);
  out += fewest.kept ? ". This is the result (--few)." : ".";
  if (run.tightened())
    out +=
        " F is that of the tightened search which found the body, not that of the task as it was "
        "asked.";
  return out + physics_words(fewest);
}

void add_fewest(Html& page, const RunRecord& run) {
  const std::string words = fewest_words(run);
  if (words.empty()) return;
  page.element("h3", "How few changes would do").element("p", words);
  page.open("div", {{"class", "charts single"}}).raw(fewest_chart(*run.fewest_changes)).close();
  page.note(
      "Each point is a body of which only so many parameters differ from the initial one, the rest "
      "and the motion optimised again. Found by putting back what costs least; another choice of "
      "as many may do better. Rings mark what MuJoCo passes at three gains for a few cycles. "
      "optimize --few hands back the body with the fewest changes that keeps the share above.");
}

}  // namespace legwright
