// SPDX-License-Identifier: Apache-2.0
// What the changed body does: parameters beside figures, before and after. The attribution follows
// in the same section of the page.
#include <fmt/format.h>

#include <algorithm>

#include "tools/report/changed_parameters.hpp"
#include "tools/report/design_effect.hpp"
#include "tools/report/outer_words.hpp"
#include "tools/report/parameter_view.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostShownParameters = 8;

void open_table(Html& page, const char* title) {
  page.open("div")
      .element("h3", title)
      .open_table("gains", {{""}, {"before", "n"}, {"after", "n"}, {"change", "n"}});
}

void add_effect_row(Html& page, const std::string& what, const std::string& before,
                    const std::string& after, const std::string& change) {
  page.open("tr").element("td", what);
  for (const std::string& cell : {before, after, change}) page.number(cell);
  page.close();
}

/// A length by its share, an angle or what began at zero by its amount.
std::string parameter_change(const ParameterView& p) {
  if (p.angle || p.initial == 0.0) return p.change();
  return change_words((p.final - p.initial) / std::abs(p.initial));
}

void add_parameters(Html& page, const RunData& data) {
  const std::vector<ChangedParameter> all = changed_parameters(data.run).list;
  open_table(page, "The body");
  for (std::size_t k = 0; k < std::min(all.size(), kMostShownParameters); ++k) {
    const ParameterView& p = all[k].view;
    add_effect_row(page, spaced(p.name), p.with_unit(p.initial), p.with_unit(p.final),
                   parameter_change(p));
  }
  page.close().close();
  if (all.size() > kMostShownParameters)
    page.note(fmt::format("… and {} more, below.", all.size() - kMostShownParameters));
  page.close();
}

/// What of the two designs makes the difference between their figures.
std::string what_differs(const RunRecord& run) {
  if (run.body_kept()) return "; after: the same body, so the difference is the gait’s.";
  return run.tightened() ? "; after: with a gait that was tightened, too, so that part of the "
                           "difference is the gait’s."
                         : ", so the difference is the body’s.";
}

/// Parameters beside figures, before and after.
void add_effect(Html& page, const RunData& data) {
  const bool kept = data.run.body_kept();
  const std::string body = body_words(data), effect = effect_words(data);
  if (!kept && body.empty()) return;  // nothing changed yet
  page.element("p", !kept            ? fmt::format("{} {}", body, effect)
                    : effect.empty() ? "The body stays as it is."
                                     : effect);
  if (const std::string outer = outer_words(data); !outer.empty()) page.element("p", outer);
  page.open("div", {{"class", "charts"}});
  if (!kept) add_parameters(page, data);
  open_table(page, "What it does");
  for (const EffectRow& row : effect_rows(data))
    add_effect_row(page, row.what, row.before, row.after,
                   row.effect.change ? change_words(*row.effect.change) : "");
  page.close().close().close().close();
  if (!data.metrics)
    add_hint(page, "What the bodies do in MuJoCo has not been measured yet.", "validate", data);
  page.note("Before: the initial body with the gait that is best for it" + what_differs(data.run) +
            " Torque and power are those at default servo gains.");
  add_gap_note(page, data.run, "F is");
}

}  // namespace

void add_design_effect(Html& page, const RunData& data) {
  if (data.run.motion_only) return;  // nothing did
  const bool kept = data.run.body_kept();
  page.open("section").element("h2", kept ? "Why the body did not change" : "Why the body changed");
  add_effect(page, data);
  if (!kept) {
    add_attribution(page, data);
    add_fewest(page, data.run);
  }
  page.close();
}

}  // namespace legwright
