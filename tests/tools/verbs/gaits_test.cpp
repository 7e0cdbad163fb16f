// SPDX-License-Identifier: Apache-2.0
// `legwright gaits`: what it draws fits a terminal and says of each gait what the library knows.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "optimizer/motion/gait.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

using test::call;
using test::contains;
using test::Outcome;

TEST(Gaits, DrawsEachGaitWithinEightyColumns) {
  const Outcome outcome = call({"gaits"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 80u) << line;
  for (const int feet : gait_library_feet())
    for (const GaitPattern& pattern : gait_library(feet))
      EXPECT_TRUE(contains(outcome.out, "\n" + pattern.name + ": " + pattern.about + "\n"));
}

TEST(Gaits, DrawsTheTrotAsItIs) {
  const Outcome outcome = call({"gaits", "trot"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string stance(30, '#'), swing(30, '.'), first = stance + swing,
                                                     second = swing + stance;
  std::string drawn = "  duty 0.5; order FL+HR, FR+HL; 2 of 4 feet on the ground\n";
  drawn.append("    FL  ").append(first).append("\n    FR  ").append(second);
  drawn.append("\n    HL  ").append(second).append("\n    HR  ").append(first);
  drawn.append("\n  feet  ").append(60, '2');
  EXPECT_TRUE(contains(outcome.out, drawn)) << outcome.out;
  EXPECT_FALSE(contains(outcome.out, "pace"));
}

TEST(Gaits, JsonHoldsTheLibrary) {
  const Json json = Json::parse(call({"gaits", "--feet", "6", "--json"}).out, nullptr, false);
  ASSERT_FALSE(json.is_discarded());
  ASSERT_EQ(json["gaits"].size(), 3u);
  const Json& tripod = json["gaits"][0];
  EXPECT_EQ(tripod["name"], "tripod");
  EXPECT_EQ(tripod["places"], (Json{"FL", "FR", "ML", "MR", "HL", "HR"}));
  EXPECT_EQ(tripod["duty"], (Json{0.5, 0.5, 0.5, 0.5, 0.5, 0.5}));
  EXPECT_EQ(tripod["order"], (Json{{"FL", "MR", "HL"}, {"FR", "ML", "HR"}}));
  EXPECT_EQ(tripod["support"], (Json{{"least", 3}, {"most", 3}}));
}

TEST(Gaits, TakesPartOfANameAndTeachesWhereThereIsNone) {
  const Outcome both = call({"gaits", "gallop"});
  EXPECT_EQ(both.code, 0);
  EXPECT_TRUE(contains(both.out, "transverse_gallop:") && contains(both.out, "rotary_gallop:"));
  const Outcome typo = call({"gaits", "trott"});
  EXPECT_EQ(typo.code, 2);
  EXPECT_TRUE(contains(typo.err, "did you mean 'trot'?")) << typo.err;
  const Outcome elsewhere = call({"gaits", "trot", "--feet", "6"});
  EXPECT_EQ(elsewhere.code, 2);
  EXPECT_TRUE(contains(elsewhere.err, "for 6 feet")) << elsewhere.err;
  EXPECT_EQ(call({"gaits", "--feet", "3"}).code, 2);
  const Outcome eight = call({"gaits", "--feet", "8"});
  EXPECT_EQ(eight.code, 0) << eight.err;
  EXPECT_TRUE(contains(eight.out, "order L1+R2+L3+R4, R1+L2+R3+L4")) << eight.out;
}

}  // namespace
}  // namespace legwright
