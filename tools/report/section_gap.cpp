// SPDX-License-Identifier: Apache-2.0
// What `optimize --physics-steps` did to the gait after the optimisation, and what else on the page
// is therefore of another gait than the result.
#include <fmt/format.h>

#include "tools/report/gap_view.hpp"
#include "tools/report/page_template.hpp"
#include "tools/report/sections.hpp"

namespace legwright {
namespace {

void add_side(Html& page, const char* head, const GapSide& side) {
  page.open("li").element("b", head).text(" ");
  add_pass(page, side.pass);
  page.text(", ").text(side.words).close();
}

}  // namespace

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
