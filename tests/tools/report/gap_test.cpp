// SPDX-License-Identifier: Apache-2.0
// What the report tells of `optimize --physics-steps`.
#include <algorithm>

#include "tests/support/text.hpp"
#include "tests/tools/report/hostile_names.hpp"
#include "tests/tools/report/run_fixture.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/report/html.hpp"

namespace legwright {
namespace {

class GapReport : public RunFixture {
 protected:
  void step(const std::function<void(Json&)>& change = [](Json&) {}) {
    Json found = physics_steps(true);
    change(found);
    edit_run([&](Json& run) { run["physics_steps"] = found; });
  }
  std::string summary() { return report_summary(read_run(run_)); }
};

TEST_F(GapReport, SaysWhatChangedAndWhatIsOfTheGaitBefore) {
  EXPECT_FALSE(has(page(), "Closing the gap"));
  EXPECT_FALSE(has(summary(), "Closing the gap"));
  step();
  const std::string page = this->page(), summary = this->summary();
  expect_well_formed(page);
  for (const char* part :
       {"speed × 1.012, swing height × 1.05</b>",
        "<b>Before:</b> <span class=\"bad\">✗ fail</span>, 93 % of it<",
        "Confirmed by MuJoCo, after:</b> <span class=\"good\">✓ pass</span>, 100 % of it<",
        "1 of 2 steps", "The gait was changed after the", "F and the planned speed are of the gait",
        "The terms are of the gait", "It is of the gait"})
    EXPECT_TRUE(has(page, part)) << part;
  EXPECT_FALSE(has(page, "margins × 1"));
  EXPECT_EQ(count_of(summary, "**Closing the gap.**"), 1U) << summary;
  EXPECT_TRUE(in_order(summary, {"**Closing the gap.** speed × 1.012, swing height × 1.05",
                                 "Before: 93 % of it", "after: 100 % of it", "certificate", "\n"}));
}

TEST_F(GapReport, WithoutAConfirmedStepEverythingIsOfOneGait) {
  step([](Json& found) { found["changed"] = false; });
  const std::string page = this->page();
  expect_well_formed(page);
  EXPECT_TRUE(has(page, "No step was confirmed to be better"));
  EXPECT_FALSE(has(page, "of the gait that the optimisation ended with"));
  EXPECT_FALSE(has(page, "The gait was changed after"));
  EXPECT_TRUE(has(summary(), "No step was confirmed to be better"));
}

TEST_F(GapReport, OfAnotherFormIsRefusedByKey) {
  for (const char* key : {"before", "after", "scalars", "changed", "steps"}) {
    const std::string where = std::string("run.json: physics_steps.") + key;
    for (const Json& value : {Json(nullptr), Json("x"), Json(-1), Json::array({1, "x", nullptr}),
                              Json::object({{"pass", 1}, {"line", 2}, {"speed", "x"}})}) {
      step([&](Json& found) { found[key] = value; });
      EXPECT_TRUE(has(refusal_of(run_), where)) << value << refusal_of(run_);
    }
    step([&](Json& found) { found.erase(key); });
    EXPECT_TRUE(has(refusal_of(run_), where + ": expected a value, found no such key"));
  }
  for (const Json& all : {Json(1), Json::array({1})}) {
    edit_run([&](Json& run) { run["physics_steps"] = all; });
    EXPECT_TRUE(has(refusal_of(run_), "run.json: physics_steps: expected an object"));
  }
  edit_run([](Json& run) { run["physics_steps"] = nullptr; });
  EXPECT_FALSE(has(page(), "Closing the gap"));
}

TEST_F(GapReport, StaysShortWhateverItsNumbers) {
  step([](Json& found) {
    for (int k = 0; k < 500; ++k) found["scalars"][std::to_string(k)] = 1e300;
    found["after"]["line"] = std::string(5000, 'x');
  });
  expect_well_formed(page());
  EXPECT_LT(summary().size(), 8000U);
}

TEST_F(GapReport, HostileNamesStayText) {
  const auto name_all = [&](const std::string& name) {
    step([&](Json& found) {
      found["scalars"][name] = 1.5;
      found["before"]["line"] = found["after"]["line"] = name;
    });
  };
  name_all("plain");
  const std::size_t expected = tags_of(page());
  for (const std::string& raw : hostile_names()) {
    const std::string name = clean_utf8(raw);
    name_all(name);
    expect_well_formed(page());
    EXPECT_EQ(tags_of(page()), expected) << name;
    EXPECT_FALSE(has(summary(), "<")) << name;
  }
}

}  // namespace
}  // namespace legwright
