// SPDX-License-Identifier: Apache-2.0
// What the verdict is made of: each limit with what was measured.
#include <fmt/format.h>

#include <algorithm>

#include "tools/report/judged_words.hpp"
#include "tools/report/page_template.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

std::string row_html(const LimitRow& row) {
  return fill(
      R"(<tr class="{row}"><td class="mark {mark}">{tick}</td><td class="head"><b>{what}</b></td>
<td class="n" data-label="measured">{measured}</td><td class="n" data-label="limit">{bound}</td>
<td data-label="worst at">{where}</td></tr>
)",
      {{"row", row.pass ? "" : "failed"},
       {"mark", row.pass ? "good" : "bad"},
       {"tick", row.pass ? "✓" : "✗"},
       {"what", label_of(row)},
       {"measured", measured_words(row)},
       {"bound", bound_words(row)},
       {"where", row.where.empty() ? "–" : spaced(row.where)}});
}

std::string table_html(const std::vector<LimitRow>& rows) {
  return fill(
      R"(<table class="limits stack"><thead><tr><th></th><th></th><th class="n">measured</th>
<th class="n">limit</th><th>worst at</th></tr></thead><tbody>
{rows}</tbody></table>
)",
      {Hole::markup("rows", each(rows, row_html))});
}

}  // namespace

void add_limits(Html& page, const RunData& data) {
  page.open("section").element("h2", "Limits");
  const auto after = data.limits_of(Design::result), before = data.limits_of(Design::initial);
  if (after.empty() && before.empty()) {
    add_hint(page,
             !data.verdict ? "Nothing has been measured against the limits yet."
                           : "verdict.json does not list the limits one by one.",
             "validate", data);
    page.close();
    return;
  }
  if (!after.empty())
    page.raw(fill(R"(<p>{kept} A verdict passes where all are; each is taken at its worst over the
servo gains that were played.</p>
{table})",
                  {{"kept", limits_kept(after)}, Hole::markup("table", table_html(after))}));
  if (!before.empty() && !motion_only(data))
    page.raw(fill(R"(<details><summary>The same before the {what} changed</summary><p>{kept}</p>
{table}</details>
)",
                  {{"what", data.run.body_kept() ? "gait" : "body"},
                   {"kept", limits_kept(before)},
                   Hole::markup("table", table_html(before))}));
  page.close();
}

}  // namespace legwright
