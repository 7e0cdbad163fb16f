// SPDX-License-Identifier: Apache-2.0
// Top of the page: the two verdicts, and the pictures that go with them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/files/atomic_file.hpp"
#include "tools/image/png.hpp"
#include "tools/report/gap_view.hpp"
#include "tools/report/number_words.hpp"
#include "tools/report/outer_words.hpp"
#include "tools/report/page_template.hpp"
#include "tools/report/sections.hpp"
#include "tools/report/words.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// At most `most` of the iterations, first and last among them, the others where F fell most.
std::vector<int> spread(const RunData& data, const std::vector<int>& drawn, std::size_t most) {
  if (drawn.size() <= most) return drawn;
  const auto cost = [&](int i) { return data.iterations[static_cast<std::size_t>(i)].F; };
  std::vector<double> way{0.0};  // how far the run had come, in powers of F and a little by count
  for (std::size_t k = 1; k < drawn.size(); ++k) {
    const double ratio = std::abs(cost(drawn[k - 1]) / cost(drawn[k]));
    way.push_back(way.back() + 0.03 +
                  (ratio > 0.0 && std::isfinite(ratio) ? std::abs(std::log(ratio)) : 0.0));
  }
  std::vector<int> shown{drawn.front()};
  std::size_t next = 1;
  for (std::size_t n = 1; n < most; ++n) {  // leaves enough for those that are still to be chosen
    const double goal = way.back() * static_cast<double>(n) / static_cast<double>(most - 1);
    const std::size_t last = drawn.size() - (most - n);
    while (next < last && way[next] < goal) ++next;
    shown.push_back(drawn[next++]);
  }
  return shown;
}

constexpr std::uintmax_t kMostMoving = 1'500'000, kMostStill = 200'000;  // bytes

/// The gait in motion, after the last design.
void add_gait(Html& page, const RunData& data, PictureBudget& budget) {
  const char* const picture = "result/gait.webp";
  const fs::path gait = data.root / picture;
  if (add_of_another(page, data, picture, "The gait in motion.") || !fs::exists(gait)) return;
  const std::string head = read_head(gait, 12);
  if (head.size() < 12 || head.substr(0, 4) != "RIFF" || head.substr(8) != "WEBP") return;
  if (!budget.take(gait, kMostMoving)) {
    page.note("The gait in motion. " + too_large(gait));
    return;
  }
  const int last = std::max(static_cast<int>(data.iterations.size()) - 1, 0);
  const fs::path still =
      shows_iteration(data, last) ? data.iteration(last) / "frame.png" : fs::path();
  add_moving(page, gait, still, "The gait, in real time.",
             "As simulated where it passed, otherwise as planned.");
}

/// What the plan itself falls short of, and what else than F the body minimised.
void add_plan_notes(Html& page, const RunData& data) {
  if (const auto& reasons = data.run.reasons; reasons && !reasons->empty()) {
    page.open("div", {{"class", "note wide"}});
    page.element("p", "The plan does not do what the task asks for:").open("ul");
    for (const std::string& reason : *reasons) page.element("li", reason);
    page.close().close();
  }
  if (data.verdict && data.run.stopped_early())
    page.note(
        fmt::format("Warning: the search did not come to its end (status “{}”): the verdict is of "
                    "the best design so far, not of its result.",
                    data.run.status),
        "note wide");
  if (data.verdict && data.verdict->home_touches)
    page.note("Warning: " + data.verdict->home_touches->line + ".", "note wide");
  if (data.verdict && data.verdict->not_judged)
    page.note("Warning: " + data.verdict->not_judged->line + ".", "note wide");
  if (data.verdict && data.verdict->never_touch)
    page.note(data.verdict->never_touch->line + ".", "note wide");
  if (data.verdict && data.verdict->overridden)
    page.note("In MuJoCo " + data.verdict->overridden->line + ".", "note wide");
  if (gait_was_stepped(data.run))
    page.note(
        "The gait was changed after the optimisation, see “Closing the gap”: verdicts, "
        "pictures and measurements are of the changed gait; F, its terms, the planned "
        "speed by iteration and the certificate are of the one before.",
        "note wide");
  const auto& outer = data.run.outer;
  if (!outer) return;
  const std::string reference =
      outer->reference ? " over " + outer_amount_words(*outer, outer->reference) : "";
  page.note(fmt::format("Outer objective: the motion minimises F, the body F + J, where J is {} "
                        "times {}{}; J ended at {}.",
                        short_number(outer->weight), spaced(outer->objective), reference,
                        short_number(data.run.final_J)),
            "note wide");
}

}  // namespace

void add_verdicts(Html& page, const RunData& data) {
  page.open("section", {{"class", "cards"}});
  if (motion_only(data)) {
    add_card(page, data.verdict_of(Design::result), "Verdict",
             "the initial body: only its gait was optimised");
  } else {
    add_card(page, data.verdict_of(Design::initial), "Before",
             "initial body, its gait optimised for the task");
    add_card(page, data.verdict_of(Design::result), "After", result_words(data.run));
  }
  add_plan_notes(page, data);
  if (!data.verdict) {
    const bool damaged = fs::exists(data.root / "result" / "verdict.json");
    add_hint(page,
             data.of_another ? std::string("No verdict: result/verdict.json is ") + kOfAnother + "."
             : damaged       ? "No verdict: result/verdict.json could not be used."
                             : "No verdict yet: the gaits have not been played in MuJoCo.",
             "validate", data);
  } else {
    page.note(
        "Verdicts are MuJoCo’s: each gait is played as planned, at half, default and "
        "double servo gains.",
        "note wide");
    if (data.without_sums)
      page.note(std::string("The verdict is ") + kWithoutSums + ".", "note wide");
  }
  page.close();
}

void add_pictures(Html& page, const RunData& data, PictureBudget& budget) {
  page.open("section").element("h2", motion_only(data) ? "Pictures" : "Before and after");
  const char* const planned = "result/strip_before_after.png";
  if (!add_strip_if(page, data, "result/strip_physics.png", "What physics did.",
                    "The camera stands still; the thin line is the start, the coloured one the way "
                    "of the trunk.",
                    budget) &&
      shows_this(data, planned)) {
    add_hint(page, "No pictures of the simulation yet.", !data.metrics ? "validate" : "render",
             data);
  }
  add_gait(page, data, budget);
  if (!add_strip_if(page, data, planned, "What was planned.",
                    "One cycle at the same camera and phases; dots are the feet seen from above, "
                    "filled where they bear.",
                    budget))
    add_hint(page, "No film strips yet.", "render", data);
  page.close();
}

void add_gallery(Html& page, const RunData& data) {
  std::vector<int> drawn;
  int others = 0;
  for (int i = 0; i < static_cast<int>(data.iterations.size()); ++i) {
    if (!fs::exists(data.iteration(i) / "frame.png")) continue;
    if (shows_iteration(data, i))
      drawn.push_back(i);
    else
      ++others;
  }
  if (others > 0)
    page.note(
        fmt::format("Left out: {} frame.png of iterations, not of the designs that stand "
                    "beside them: render again.",
                    others));
  if (drawn.empty()) return;
  constexpr std::size_t kMost = 12;  // keeps the page small: some 30 kB each
  const std::vector<int> shown = spread(data, drawn, kMost);
  page.open("section").element("h2", "The body, iteration by iteration");
  page.open("div", {{"class", "gallery"}});
  for (const int index : shown) {
    try {
      const auto bytes = encode_png(downsample(read_png(data.iteration(index) / "frame.png"), 2));
      if (bytes.size() > kMostStill) throw std::runtime_error("too large");
      const std::string name = fmt::format("iteration {}", index);
      page.open("figure").lone("img", {{"src", data_uri("image/png", bytes)}, {"alt", name}});
      const double cost = data.iterations[static_cast<std::size_t>(index)].F;
      page.element("figcaption", fmt::format("{} · F {}", index, short_number(cost))).close();
    } catch (const std::runtime_error&) {
      page.note(fmt::format("iteration {}: its picture cannot be shown", index));
    }
  }
  page.close().close();
}

}  // namespace legwright
