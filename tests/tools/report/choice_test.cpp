// SPDX-License-Identifier: Apache-2.0
// What the report tells of the choice between designs.
#include "tests/support/text.hpp"
#include "tests/tools/report/hostile_names.hpp"
#include "tests/tools/report/run_fixture.hpp"
#include "tools/report/html.hpp"

namespace legwright {
namespace {

Json candidate_json(const char* name, double F, bool pass, const char* line) {
  return {{"name", name},
          {"F", F},
          {"played", {{"merit", pass ? 0.0 : 2.5}, {"pass", pass}, {"line", line}}}};
}

class ChoiceReport : public RunFixture {
 protected:
  void choose(std::vector<Json> candidates, const char* chosen, bool pass) {
    edit_run([&](Json& run) {
      run["choice"] = {{"chosen", chosen},
                       {"pass", pass},
                       {"rollouts", 6},
                       {"seconds", 1.5},
                       {"candidates", candidates}};
    });
  }
  const Json optimum_ = candidate_json("optimum", 1.25, false, "FAIL  walk: reaches 81 % of it"),
             tightened_ =
                 candidate_json("tightened: larger margins", 1.5, true, "PASS  walk: 99 % of it");
};

TEST_F(ChoiceReport, TellsWhatWasHandedBackInsteadOfTheOptimumAndWhy) {
  EXPECT_FALSE(has(page(), "What MuJoCo said during the search"));
  choose({optimum_, tightened_}, "tightened: larger margins", true);
  const std::string page = this->page();
  expect_well_formed(page);
  EXPECT_TRUE(in_order(page, {"What MuJoCo said during the search", "F 1.25", "reaches 81 %",
                              "2 designs", "tightened: larger margins", "F 1.5", "passes"}));
  EXPECT_TRUE(in_order(page, {"<td>optimum</td>", "✗ fail", "reaches 81 % of it",
                              "<b>tightened: larger margins</b>", "✓ pass", "99 % of it"}));
}

TEST_F(ChoiceReport, TellsThatNonePassesAndWhatWasPicked) {
  choose({optimum_, candidate_json("initial", 9.0, false, "FAIL  walk: falls")}, "optimum", false);
  EXPECT_TRUE(in_order(page(), {"2 designs", "optimum", "none passes"}));
  EXPECT_FALSE(has(page(), "picked instead"));
  edit_run([](Json& run) { run["picked"] = "iteration 3"; });
  EXPECT_TRUE(has(page(), "iteration 3 was picked instead"));
}

TEST_F(ChoiceReport, IsSilentWhereTheOptimumPasses) {
  choose({candidate_json("optimum", 1.25, true, "PASS  walk: 99 % of it")}, "optimum", true);
  EXPECT_FALSE(has(page(), "What MuJoCo said during the search"));
}

TEST_F(ChoiceReport, NamesAreText) {
  choose({optimum_, candidate_json("<b>&\"", 1.5, true, "PASS  walk: <i>99</i>")}, "<b>&\"", true);
  const std::string page = this->page();
  expect_well_formed(page);
  EXPECT_FALSE(has(page, "<i>99</i>"));
}

}  // namespace
}  // namespace legwright
