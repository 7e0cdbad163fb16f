// SPDX-License-Identifier: Apache-2.0
// What `optimize --physics-steps` did to the gait after the optimisation, and what else on the page
// is therefore of another gait than the result.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/report/page_template.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostScalars = 12;
constexpr double kUnchanged = 5e-5;  // a factor this close to 1 would be shown as 1

/// "speed × 1.012, swing height × 1.05"
std::string factors_words(const ByName<double>& scalars) {
  std::string out;
  std::size_t shown = 0;
  for (const auto& [name, factor] : scalars) {
    if (!std::isfinite(factor) || std::abs(factor - 1.0) < kUnchanged) continue;
    if (shown++ == kMostScalars) return out + ", …";
    out += fmt::format("{}{} × {:.4g}", out.empty() ? "" : ", ", spaced(name), factor);
  }
  return out;
}

GapSide side_of(const PlayedGait& gait) {
  GapSide out{gait.pass, verdict_details(gait.line)};
  if (out.words.empty()) out.words = "not told";
  return out;
}

void add_side(Html& page, const char* head, const GapSide& side) {
  page.open("li").element("b", head).text(" ");
  add_pass(page, side.pass);
  page.text(", ").text(side.words).close();
}

}  // namespace

std::optional<GapView> gap_of(const RunRecord& run) {
  if (!run.physics_steps) return std::nullopt;
  const PhysicsStepsRecord& found = *run.physics_steps;
  GapView gap{found.changed,        factors_words(found.scalars), side_of(found.before),
              side_of(found.after), found.steps.size(),           0};
  if (gap.factors.empty()) gap.factors = "by how much is not told";
  for (const PhysicsStepRecord& step : found.steps) gap.confirmed += step.accepted ? 1 : 0;
  return gap;
}

bool gait_was_stepped(const TaskRecord& task) {
  return task.physics_steps && task.physics_steps->changed;
}

bool gait_was_stepped(const RunRecord& run) {
  if (run.physics_steps && run.physics_steps->changed) return true;
  return run.tasks && std::any_of(run.tasks->begin(), run.tasks->end(),
                                  [](const TaskRecord& task) { return gait_was_stepped(task); });
}

void add_gap_note(Html& page, const RunRecord& run, const std::string& what) {
  if (gait_was_stepped(run))
    page.raw(fill(R"(<p class="note">{what} of the gait that the optimisation ended with, before )"
                  "the steps of “Closing the gap” changed it.</p>\n",
                  {{"what", what}}));
}

void add_gap(Html& page, const RunData& data) {
  const auto gap = gap_of(data.run);
  if (!gap) return;
  page.open("section").element("h2", "Closing the gap");
  page.note(
      "After the optimisation the gait was played in MuJoCo and a few of its scalars were "
      "changed; the body stays. A step counts only where the roll-outs come closer to the "
      "task than before.");
  if (!gap->changed) {
    page.element("p", "No step was confirmed to be better: the gait stays as it was.");
  } else {
    page.open("p").element("b", gap->factors).close();
  }
  page.open("ul", {{"class", "changes"}});
  if (gap->changed) add_side(page, "Before:", gap->before);
  add_side(page, gap->changed ? "Confirmed by MuJoCo, after:" : "As it was:", gap->after);
  page.close();
  if (gap->steps > 0)
    page.note(fmt::format("{} of {} steps were confirmed.", gap->confirmed, gap->steps));
  page.close();
}

}  // namespace legwright
