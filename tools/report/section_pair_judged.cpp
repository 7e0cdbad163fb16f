// SPDX-License-Identifier: Apache-2.0
// Two runs side by side: limits, margins, origin.
#include <fmt/format.h>

#include <algorithm>

#include "tools/report/judged_words.hpp"
#include "tools/report/number_words.hpp"
#include "tools/report/pair_report.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/svg_bars.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

void add_limit_cell(Html& page, const LimitRow* row, const char* name) {
  page.open("td", {{"class", "n"}, {"data-label", name}});
  if (row == nullptr) {
    page.text("–").close();
    return;
  }
  page.element("span", row->pass ? "✓ " : "✗ ", {{"class", row->pass ? "good" : "bad"}});
  page.text(measured_words(*row));
  if (!row->where.empty()) page.element("small", spaced(row->where));
  page.close();
}

void add_margin(Html& page, const RobustnessFactor* a, const RobustnessFactor* b) {
  const RobustnessFactor& any = a != nullptr ? *a : *b;
  page.open("tr").open("td", {{"class", "head"}});
  page.element("b", label_of(any)).close();
  // On one axis, so that the bars can be compared.
  const double low = std::min((a ? a : b)->tested_low, (b ? b : a)->tested_low),
               high = std::max((a ? a : b)->tested_high, (b ? b : a)->tested_high);
  for (const auto& [name, factor] : {std::pair{"A", a}, {"B", b}}) {
    page.open("td", {{"class", "margin"}, {"data-label", name}});
    if (factor == nullptr) {
      page.text("–").close();
      continue;
    }
    page.raw(range_bar({low, high, factor->low, factor->high, finite(factor->nominal)}));
    page.element("small", margin_words(*factor)).close();
  }
  page.close();
}

}  // namespace

void add_pair_limits(Html& page, const RunPair& pair) {
  page.open("section").element("h2", "Limits");
  const auto limits_a = pair.a.limits_of(Design::result),
             limits_b = pair.b.limits_of(Design::result);
  auto rows = joined_by_name(limits_a, limits_b);
  if (rows.empty()) {
    add_hint(page, "Neither verdict lists its limits.", "validate", pair.a);
    page.close();
    return;
  }
  std::stable_partition(rows.begin(), rows.end(), [](const auto& row) {
    return (row.first != nullptr && !row.first->pass) ||
           (row.second != nullptr && !row.second->pass);
  });
  page.open_table("stack pair limits", {{""}, {"A", "n"}, {"B", "n"}, {"limit", "n"}});
  for (const auto& [a, b] : rows) {
    const LimitRow& any = a != nullptr ? *a : *b;
    page.open("tr").open("td", {{"class", "head"}});
    page.element("b", label_of(any)).close();
    add_limit_cell(page, a, "A");
    add_limit_cell(page, b, "B");
    std::string bound = bound_words(any);
    if (a != nullptr && b != nullptr && bound_words(*b) != bound)
      bound = "A " + bound + "; B " + bound_words(*b);
    page.number(bound, "limit").close();
  }
  page.close().close().close();
}

void add_pair_margins(Html& page, const RunPair& pair) {
  page.open("section").element("h2", "Robustness: how much they bear");
  const auto rows = joined_by_name(pair.a.factors(), pair.b.factors());
  // Where a gait fails undisturbed there is nothing to vary, and validating it again would not
  // help.
  const std::string none[] = {no_margins_words(pair.a), no_margins_words(pair.b)};
  const char* const names[] = {"A", "B"};
  for (std::size_t k = 0; k < 2; ++k)
    if (!none[k].empty()) page.element("p", fmt::format("{}: {}", names[k], none[k]));
  if (rows.empty()) {
    const RunData* const runs[] = {&pair.a, &pair.b};
    if (none[0].empty() && none[1].empty()) {
      add_hint(page, "Nothing was varied yet in either run.", "validate", pair.a);
    } else {
      for (std::size_t k = 0; k < 2; ++k)
        if (none[k].empty())
          add_hint(page, fmt::format("{}: nothing was varied yet.", names[k]), "validate",
                   *runs[k]);
    }
    page.close();
    return;
  }
  page.open_table("stack pair margins", {{""}, {"A"}, {"B"}});
  for (const auto& [a, b] : rows) add_margin(page, a, b);
  page.close().close();
  for (const auto& [name, run] : {std::pair{"A", &pair.a}, {"B", &pair.b}}) {
    const std::string words = run->robustness ? survival_words(run->robustness->monte_carlo) : "";
    if (!words.empty()) page.element("p", fmt::format("{}: {}", name, words));
  }
  page.close();
}

void add_pair_origin(Html& page, const RunPair& pair) {
  page.open("section").element("h2", "Where this comes from");
  page.open("table", {{"class", "origin stack"}}).open("tbody");
  for (const auto& [name, run] : {std::pair{"A", &pair.a}, {"B", &pair.b}}) {
    page.open("tr").element("td", fmt::format("{}: folder", name), {{"class", "head"}});
    page.open("td").element("code", run->root.generic_string()).close().close();
    for (const char* key : {"task.toml", "robot.xml"}) {
      const std::string* const hash = run->run.sha256.find(key);
      if (hash == nullptr) continue;
      page.open("tr").element("td", fmt::format("{}: SHA-256 of {}", name, key),
                              {{"class", "head"}});
      page.open("td").element("code", *hash).close().close();
    }
    for (const char* key : {"legwright", "mujoco"}) {
      const std::string* const version = run->run.versions.find(key);
      if (version == nullptr) continue;
      page.open("tr").element("td", fmt::format("{}: {}", name, key), {{"class", "head"}});
      page.element("td", *version).close();
    }
  }
  page.close().close();
  for (const auto& [name, run] : {std::pair{"A", &pair.a}, {"B", &pair.b}})
    for (const std::string& note : run->notes)
      page.open("p", {{"class", "hint"}})
          .text(fmt::format("Could not be used of {}: {}", name, note))
          .close();
  page.close();
}

}  // namespace legwright
