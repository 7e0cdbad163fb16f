// SPDX-License-Identifier: Apache-2.0
// Whether the printed parts bear the gait: what `legwright parts` found of the run as printed.
#include <fmt/format.h>

#include <algorithm>

#include "tools/report/number_words.hpp"
#include "tools/report/page_template.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

constexpr std::size_t kMostStrengthRows = 200;

std::string strength_row_html(const PartStrength& part) {
  return fill(
      R"(<tr class="{row}"><td class="mark {mark}">{tick}</td><td class="head"><b>{part}</b></td>
<td data-label="load">{load}</td><td class="n" data-label="factor">{factor}</td>
<td class="n" data-label="at least">{least}</td><td data-label="stressed most">{where}</td></tr>
)",
      {{"row", part.pass ? "" : "failed"},
       {"mark", part.pass ? "good" : "bad"},
       {"tick", part.pass ? "✓" : "✗"},
       {"part", spaced(part.part)},
       {"load", part.load},
       {"factor", part.factor ? short_number(part.factor) : "not judged"},
       {"least", part.least_factor ? short_number(part.least_factor) : "–"},
       {"where", part.where}});
}

}  // namespace

std::string strength_words(const StrengthRecord& strength) {
  const PartStrength* least = nullptr;
  double most_used = 0.0;  // share of what passes
  for (const PartStrength& part : strength.parts) {
    if (!part.factor || !part.least_factor || !(*part.factor > 0.0)) continue;
    const double used = *part.least_factor / *part.factor;
    if (least == nullptr || used > most_used) least = &part, most_used = used;
  }
  if (least == nullptr) return "No part was judged.";
  const auto failed = std::count_if(strength.parts.begin(), strength.parts.end(),
                                    [](const PartStrength& part) { return !part.pass; });
  const std::string verdict =
      failed ? fmt::format("{} of {} are too weak", failed, strength.parts.size())
             : fmt::format("All {} are strong enough", strength.parts.size());
  return fmt::format("{}. Nearest to its limit: {}, {} with a safety factor of {}; {} passes.",
                     verdict, spaced(least->part), least->load, short_number(least->factor),
                     short_number(least->least_factor));
}

void add_strength(Html& page, const RunData& data) {
  if (!data.strength) return;
  std::vector<PartStrength> rows = data.strength->parts;
  rows.resize(std::min(rows.size(), kMostStrengthRows));
  page.open("section").element("h2", "Printed parts");
  page.raw(fill(R"(<p>{words}</p>
<p class="note">Each part as a beam, under what it carries while MuJoCo plays the gait and under all of its
servo's torque; the material bears {strength} MPa.</p>
<table class="limits stack"><thead><tr><th></th><th></th><th>load</th><th class="n">factor</th>
<th class="n">at least</th><th>stressed most</th></tr></thead><tbody>
{rows}</tbody></table>
)",
                {{"words", strength_words(*data.strength)},
                 {"strength", short_number(data.strength->strength)},
                 Hole::markup("rows", each(rows, strength_row_html))}));
  page.close();
}

}  // namespace legwright
