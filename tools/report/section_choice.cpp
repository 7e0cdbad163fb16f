// SPDX-License-Identifier: Apache-2.0
// Which of its designs the search handed back, and what MuJoCo said of the others.
#include <fmt/format.h>

#include <algorithm>

#include "tools/report/judged_words.hpp"
#include "tools/report/number_words.hpp"
#include "tools/report/sections.hpp"

namespace legwright {
namespace {

const CandidateRecord& chosen_of(const ChoiceRecord& choice) {
  const auto found = std::find_if(choice.candidates.begin(), choice.candidates.end(),
                                  [&](const auto& each) { return each.name == choice.chosen; });
  return found == choice.candidates.end() ? choice.candidates.front() : *found;
}

void add_row(Html& page, const CandidateRecord& candidate, bool chosen) {
  page.open("tr").open("td");
  if (chosen)
    page.element("b", candidate.name);
  else
    page.text(candidate.name);
  page.close().number(three_digits(candidate.F), "F");
  page.element("td", candidate.played.pass ? "✓ pass" : "✗ fail");
  std::string why = verdict_details(candidate.played.line);
  if (candidate.stable)
    why += fmt::format("; largest Floquet multiplier {}", candidate.multiplier
                                                              ? three_digits(*candidate.multiplier)
                                                              : "unknown: it falls");
  page.element("td", why).close();
}

}  // namespace

std::string choice_words(const RunRecord& run) {
  if (!run.choice || run.choice->candidates.size() < 2) return "";
  const ChoiceRecord& choice = *run.choice;
  const CandidateRecord &optimum = choice.candidates.front(), &chosen = chosen_of(choice);
  std::string text = fmt::format("MuJoCo does not pass the optimum of F (F {}): {}. ",
                                 three_digits(optimum.F), verdict_details(optimum.played.line));
  text += fmt::format("Of {} designs that it played the result is “{}”, F {}, ",
                      choice.candidates.size(), chosen.name, three_digits(chosen.F));
  text += choice.pass ? "the least F that passes" : "the nearest to passing; none passes";
  text += choice.by_stability() ? ", but for designs whose cycle is not stable." : ".";
  if (run.picked) text += fmt::format(" Since then {} was picked instead.", *run.picked);
  return text;
}

void add_choice(Html& page, const RunRecord& run) {
  const std::string words = choice_words(run);
  if (words.empty()) return;
  page.open("section").element("h2", "What MuJoCo said during the search");
  page.element("p", words);
  page.open("details").element("summary", "Every design that was played");
  page.open("div", {{"class", "scroll"}})
      .open_table("terms", {{"design"}, {"F", "n"}, {"in MuJoCo"}, {"why"}});
  for (const CandidateRecord& candidate : run.choice->candidates)
    add_row(page, candidate, candidate.name == run.choice->chosen);
  page.close().close().close().close();
  page.note(
      "F is that of the task as it was asked. A tightened design minimises the F of its own "
      "search, "
      "to which reasons, terms and certificate belong. Designs with files in candidates/ can be "
      "made the result by `legwright pick`.");
  page.close();
}

}  // namespace legwright
