// SPDX-License-Identifier: Apache-2.0
// What `optimize --physics-steps` did to the gait after the optimisation, and what else on the page
// is therefore of another gait than the result.
#include <fmt/format.h>

#include <cmath>

#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostScalars = 12;
constexpr double kUnchanged = 5e-5;  // a factor this close to 1 would be shown as 1

/// "speed × 1.012, swing height × 1.05"
std::string factors_words(const Json& scalars) {
  std::string out;
  if (!scalars.is_object()) return out;
  std::size_t shown = 0;
  for (const auto& [name, value] : scalars.items()) {
    const auto factor = number_at(scalars, {name.c_str()});
    if (!factor || std::abs(*factor - 1.0) < kUnchanged) continue;
    if (shown++ == kMostScalars) return out + ", …";
    out += fmt::format("{}{} × {:.4g}", out.empty() ? "" : ", ", spaced(name), *factor);
  }
  return out;
}

GapSide side_of(const Json& side) {
  GapSide out;
  if (const Json& pass = value_at(side, {"pass"}); pass.is_boolean()) out.pass = pass.get<bool>();
  out.words = text_at(side, {"line"});
  if (const std::size_t colon = out.words.find(": "); colon != std::string::npos)
    out.words.erase(0, colon + 2);  // the mark says what stands before it
  if (out.words.empty()) out.words = "not told";
  return out;
}

void add_side(Html& page, const char* head, const GapSide& side) {
  page.open("li").element("b", head).text(" ");
  if (side.pass)
    page.element("span", *side.pass ? "✓ pass" : "✗ fail", {{"class", *side.pass ? "good" : "bad"}})
        .text(", ");
  page.text(side.words).close();
}

}  // namespace

std::optional<GapView> gap_of(const Json& run) {
  const Json& found = value_at(run, {"physics_steps"});
  const Json& changed = value_at(found, {"changed"});
  if (!changed.is_boolean()) return std::nullopt;
  GapView gap;
  gap.changed = changed.get<bool>();
  gap.factors = factors_words(value_at(found, {"scalars"}));
  if (gap.factors.empty()) gap.factors = "by how much is not told";
  gap.before = side_of(value_at(found, {"before"}));
  gap.after = side_of(value_at(found, {"after"}));
  const Json& steps = value_at(found, {"steps"});
  if (!steps.is_array()) return gap;
  gap.steps = steps.size();
  for (const Json& step : steps)
    gap.confirmed += value_at(step, {"accepted"}) == Json(true) ? 1 : 0;
  return gap;
}

bool gait_was_stepped(const Json& run) {
  const auto stepped = [](const Json& json) {
    const auto gap = gap_of(json);
    return gap && gap->changed;
  };
  if (stepped(run)) return true;
  const Json& tasks = value_at(run, {"tasks"});
  if (!tasks.is_array()) return false;
  for (const Json& task : tasks)
    if (stepped(task)) return true;
  return false;
}

void add_gap_note(Html& page, const Json& run, const std::string& what) {
  if (gait_was_stepped(run))
    page.element("p",
                 what +
                     " of the gait that the optimisation ended with, before the steps of "
                     "“Closing the gap” changed it.",
                 {{"class", "note"}});
}

void add_gap(Html& page, const RunData& data) {
  const auto gap = gap_of(data.run);
  if (!gap) return;
  page.open("section").element("h2", "Closing the gap");
  page.element("p",
               "After the optimisation the gait was played in MuJoCo and a few of its scalars were "
               "changed; the body stays. A step counts only where the roll-outs come closer to the "
               "task than before.",
               {{"class", "note"}});
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
    page.element("p", fmt::format("{} of {} steps were confirmed.", gap->confirmed, gap->steps),
                 {{"class", "note"}});
  page.close();
}

}  // namespace legwright
