// SPDX-License-Identifier: Apache-2.0
// Safety factors of printed parts, on the page of the run that has their masses.
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/text.hpp"
#include "tests/tools/report/hostile_names.hpp"
#include "tests/tools/report/run_fixture.hpp"

namespace legwright {
namespace {

constexpr const char* kStrength = "result/strength.json";

class StrengthTest : public RunFixture {
 protected:
  void write(const std::vector<Json>& parts) {
    const Json record{
        {"schema", "legwright/strength"}, {"version", 1}, {"strength_MPa", 25.0}, {"parts", parts}};
    write_json(run_ / kStrength, record, Durability::process);
  }
};

Json row(const std::string& part, const std::string& load, const Json& factor, double least) {
  return {{"part", part},
          {"load", load},
          {"factor", factor},
          {"least_factor", least},
          {"where", "9.4 of 25 MPa, 15 % of the way, t = 0.189 s"},
          {"pass", factor.is_null() || factor >= least}};
}

TEST_F(StrengthTest, IsNotThereWithoutParts) {
  EXPECT_FALSE(has(page(), "Printed parts"));
  EXPECT_FALSE(has(report_summary(read_run(run_)), "Printed parts"));
}

TEST_F(StrengthTest, TellsEachFactorAndTheOneNearestToItsLimit) {
  write({row("FL_thigh", "bears the gait", 2.66, 2.0), row("FL_thigh", "bears its servo", 1.5, 1.0),
         row("FL_shank", "bears the gait, not judged", nullptr, 2.0)});
  const std::string page = this->page();
  expect_well_formed(page);
  const std::string words =
      "All 3 are strong enough. Nearest to its limit: FL thigh, bears the gait with a safety "
      "factor "
      "of 2.66; 2 passes.";
  EXPECT_TRUE(in_order(page, {"<h2>Printed parts</h2>", words.c_str(), "25 MPa", "✓", "FL thigh",
                              "2.66", "t = 0.189 s", "bears its servo", "1.5", "not judged"}));
  EXPECT_TRUE(has(report_summary(read_run(run_)), "**Printed parts.** " + words));
}

TEST_F(StrengthTest, SaysWhatIsTooWeak) {
  write(
      {row("FL_thigh", "bears the gait", 2.66, 2.0), row("HL_thigh", "bears the gait", 1.2, 2.0)});
  const std::string page = this->page();
  EXPECT_TRUE(in_order(page, {"1 of 2 are too weak. Nearest to its limit: HL thigh", "✓", "✗"}));
}

TEST_F(StrengthTest, EscapesWhatTheFileSays) {
  for (const std::string& name : hostile_names()) {
    write({row(name, name, 3.0, 2.0)});
    const std::string page = this->page();
    expect_well_formed(page);
    EXPECT_TRUE(has(page, "<h2>Printed parts</h2>")) << name;
    EXPECT_FALSE(has(page, "<script>alert(1)")) << name;
  }
}

TEST_F(StrengthTest, NotesAFileThatCannotBeUsed) {
  write({row("FL_thigh", "bears the gait", 3.0, 2.0)});
  edit(kStrength, [](Json& file) { file["parts"][0].erase("load"); });
  const std::string page = this->page();
  EXPECT_FALSE(has(page, "<h2>Printed parts</h2>"));
  EXPECT_TRUE(has(page, "strength.json"));
}

}  // namespace
}  // namespace legwright
