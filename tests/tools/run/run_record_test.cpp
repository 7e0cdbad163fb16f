// SPDX-License-Identifier: Apache-2.0
#include "tools/run/run_record.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

ChoiceRecord choice_of(CandidateRecord candidate) {
  ChoiceRecord out;
  out.candidates = {{"initial", 1.0, {0.0, true, "PASS"}, {}, {}, {}, {}}, std::move(candidate)};
  return out;
}

TEST(ChoiceRecord, TellsWhyACandidateDoesNotPass) {
  const ChoiceRecord choice =
      choice_of({"optimum", 2.0, {0.5, false, "FAIL trot: falls"}, {}, {}, {}, {}});
  EXPECT_EQ(choice.complaint("optimum", "trot"), "MuJoCo does not pass it: FAIL trot: falls");
  EXPECT_EQ(choice.complaint("initial", "trot"), std::nullopt);
  EXPECT_EQ(choice.complaint("iteration 3", "trot"), std::nullopt) << "was not played";
}

TEST(ChoiceRecord, BlamesOfSeveralTasksThoseThatFail) {
  ByName<std::string> failing;
  failing.emplace_back("pace", "FAIL pace: falls");
  const ChoiceRecord choice =
      choice_of({"optimum", 2.0, {0.5, false, "FAIL pace: falls"}, {}, failing, {}, {}});
  EXPECT_EQ(choice.complaint("optimum", "pace"), "MuJoCo does not pass it: FAIL pace: falls");
  EXPECT_EQ(choice.complaint("optimum", "sideways"), std::nullopt);
}

TEST(ChoiceRecord, KnowsWhereStabilityDecided) {
  ChoiceRecord choice;
  choice.candidates = {{"iteration 8", 4.67, {0.0, true, "PASS"}, {}, {}, false, 1.62},
                       {"tightened: wider stance", 4.69, {0.0, true, "PASS"}, {}, {}, true, 0.31}};
  choice.chosen = "tightened: wider stance";
  EXPECT_TRUE(choice.by_stability());
  choice.chosen = "iteration 8";
  EXPECT_FALSE(choice.by_stability());
}

}  // namespace
}  // namespace legwright
