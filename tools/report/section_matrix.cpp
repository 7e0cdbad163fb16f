// SPDX-License-Identifier: Apache-2.0
// Top of the page of a joint run: a verdict for each task, and each design in each task.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/gap_view.hpp"
#include "tools/report/judged_words.hpp"
#include "tools/report/number_words.hpp"
#include "tools/report/page_template.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

std::string limits_html(const RunData& run) {
  const auto limits = run.limits_of(Design::result);
  std::string words = limits.empty() ? "" : limits_kept(limits) + " ";
  if (run.robustness) words += survival_words(run.robustness->monte_carlo);
  if (run.second_engine) words += " " + engine_words(*run.second_engine);
  return words.empty() ? "" : fill("<p>{words}</p>\n", {{"words", words}});
}

void add_task_card(Html& page, const JointTaskData& task) {
  const DesignVerdict* after = task.run ? task.run->verdict_of(Design::result) : nullptr;
  const DesignVerdict* before = task.run ? task.run->verdict_of(Design::initial) : nullptr;
  std::string more;
  if (task.run) more += limits_html(*task.run);
  if (before != nullptr)
    more += fill("<p class=\"note\">Before, with the initial body: {passed}.</p>\n",
                 {{"passed", before->pass ? "passed" : "failed"}});
  more += fill("<p><a href=\"{page}\">Report of this task</a></p>",
               {{"page", href_of(task.relative / "report.html")}});
  add_card(page, after, spaced(task.name), way_words(task.task), more);
}

/// Share of the planned speed at a gain, or how it ended.
std::string gain_words(const GainMetrics* measured) {
  if (measured == nullptr) return "–";
  if (measured->fall) return fmt::format("fell, {} s", short_number(measured->fall->time));
  if (!measured->speed_ratio) return "–";
  const double share = std::round(100.0 * *measured->speed_ratio);
  return fmt::format("{}{:.0f} %", share < 0.0 ? "−" : "", std::abs(share));
}

void add_cell(Html& page, const JointData& data, const MatrixDesign& design, std::size_t t) {
  const std::optional<MatrixCellRecord>& cell = design.cells[t];
  const bool known = cell.has_value(), good = known && cell->pass;
  page.open("td", {{"class", !known ? "cell"
                             : good ? "cell good-cell"
                                    : "cell bad-cell"},
                   {"data-label", spaced(data.tasks[t].name)}});
  page.open("p").element("b", "F " + three_digits(design.cost[t]));
  if (known) add_pass(page.text(" "), good);
  page.close();
  if (known) {
    page.open("dl");
    for (const char* gain : kGains) {
      page.open("div").element("dt", gain);
      page.element("dd", gain_words(cell->gains.find(gain))).close();
    }
    page.close();
  }
  page.close();
}

/// What the common body gives up for each task, against the body of that task alone.
std::string trade_words(const JointData& data) {
  std::string out;
  const MatrixDesign& common = data.designs.back();
  for (std::size_t t = 0; t < data.tasks.size(); ++t) {
    const std::string own = "for " + data.tasks[t].name + " alone";
    for (const MatrixDesign& design : data.designs) {
      if (design.name != own || !design.cost[t] || !common.cost[t]) continue;
      out += fmt::format("{}{} costs {} with the common body and {} with its own",
                         out.empty() ? "" : "; ", spaced(data.tasks[t].name),
                         short_number(common.cost[t]), short_number(design.cost[t]));
    }
  }
  return out.empty() ? out : "F by task: " + out + ".";
}

}  // namespace

std::string stepped_words(const JointData& data) {
  std::string names;
  for (const JointTaskData& task : data.tasks)
    if (gait_was_stepped(task.task) || (task.run && gait_was_stepped(task.run->run)))
      names += (names.empty() ? "" : ", ") + spaced(task.name);
  return names.empty() ? ""
                       : fmt::format(
                             "Steps that MuJoCo confirmed changed the gait of {} after the "
                             "optimisation: F and the certificate are of the gait before.",
                             names);
}

void add_task_cards(Html& page, const JointData& data) {
  page.open("section", {{"class", "cards"}});
  for (const JointTaskData& task : data.tasks) add_task_card(page, task);
  if (const std::string words = stepped_words(data); !words.empty()) page.note(words, "note wide");
  if (!data.judged()) {
    add_hint(page,
             data.whole.of_another ? std::string("result/matrix.json is ") + kOfAnother + "."
                                   : "The bodies have not been compared in MuJoCo yet.",
             "validate", data.whole);
  } else {
    page.note(
        "One body for all tasks, each with a gait of its own. Verdicts are MuJoCo’s, at "
        "half, default and double servo gains and by what else was asked.",
        "note wide");
    if (data.whole.without_sums)
      page.note(std::string("The verdicts are ") + kWithoutSums + ".", "note wide");
  }
  page.close();
}

void add_matrix(Html& page, const JointData& data) {
  page.open("section").element("h2", "Every body in every task");
  const std::string trade = trade_words(data);
  if (!trade.empty()) page.element("p", trade);
  std::vector<TableColumn> columns{{"body"}};
  for (const JointTaskData& task : data.tasks) columns.push_back({spaced(task.name)});
  page.open_table("matrix", columns);
  for (const MatrixDesign& design : data.designs) {
    page.open("tr", {{"class", &design == &data.designs.back() ? "chosen" : ""}});
    page.open("td").element("b", spaced(design.name)).close();
    for (std::size_t t = 0; t < data.tasks.size(); ++t) add_cell(page, data, design, t);
    page.close();
  }
  page.close().close();
  if (data.judged()) {
    page.note(
        "F: cost of the best gait found for that body. Below it, the measured speed as a "
        "share of the planned one at three servo gains; 95 to 105 % at all of them is one "
        "of the conditions for a pass. Here all bodies are judged by these roll-outs alone; "
        "other numerics and disturbances, which the verdicts above count, are tried with the "
        "body for all tasks.");
  } else {
    add_hint(page, "Speeds and verdicts are not known yet.", "validate", data.whole);
  }
  page.close();
}

void add_task_pictures(Html& page, const JointData& data) {
  page.open("section").element("h2", "Before and after");
  PictureBudget budget;
  bool missing = false;
  for (const JointTaskData& task : data.tasks) {
    bool any = false;
    for (const char* strip : {"result/strip_physics.png", "result/strip_before_after.png"}) {
      if (!task.run || add_of_another(page, *task.run, strip, spaced(task.name) + ":")) continue;
      any = any || fs::exists(task.run->root / strip);
      if (!budget.take(task.run->root / strip)) continue;
      const bool physics = std::string_view(strip) == "result/strip_physics.png";
      add_strip(page, task.run->root / strip,
                spaced(task.name) + (physics ? ": what physics did." : ": what was planned."),
                physics ? "The thin line is the start, the coloured one the way of the trunk."
                        : "One cycle at the same camera and phases.");
    }
    missing = missing || !any;
  }
  if (missing) add_hint(page, "Film strips are missing.", "render", data.whole);
  if (budget.refused()) page.note("More pictures are in the reports of the tasks.");
  page.close();
}

}  // namespace legwright
