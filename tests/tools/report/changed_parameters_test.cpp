// SPDX-License-Identifier: Apache-2.0
#include "tools/report/changed_parameters.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

ParameterRecord parameter(const char* name, double final) {
  return {name, "rad", "axis_angle", "", 0.0, -1.0, 1.0, final, 1};
}

RunRecord run_of(std::vector<ParameterRecord> parameters) {
  RunRecord run;
  run.parameters = std::move(parameters);
  return run;
}

std::vector<std::string> names(const RunRecord& run) {
  std::vector<std::string> out;
  for (const ChangedParameter& each : changed_parameters(run).list) out.push_back(each.view.name);
  return out;
}

const RunRecord kRun = run_of({parameter("far", 0.9), parameter("kept", 0.0),
                               parameter("near", 0.1), parameter("half", -0.5)});

TEST(ChangedParameters, GoByWhatTheyLoweredFThenByTheirRange) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(kRun), (Names{"far", "half", "near"}));
  EXPECT_FALSE(changed_parameters(kRun).by_cost);
  RunRecord run = kRun;
  run.pull = AttributionRecord{{"near", {{"smoothness", 3.0}, {"travel", -1.0}}},
                               {"far", {{"travel", -0.5}}}};
  EXPECT_EQ(names(run), (Names{"near", "half", "far"})) << "what cost F comes last";
  EXPECT_TRUE(changed_parameters(run).by_cost);
  EXPECT_EQ(changed_parameters(run).list[0].lowered, 2.0);
  run.pull = AttributionRecord{{"near", {}}};
  EXPECT_FALSE(changed_parameters(run).by_cost) << "nothing is known";
  EXPECT_EQ(names(run), (Names{"far", "half", "near"}));
}

TEST(ChangedParameters, CountTheBoundsThatDecided) {
  const auto words = [](const std::vector<double>& values) {
    RunRecord run;
    for (const double value : values) run.parameters.push_back(parameter("p", value));
    return changed_parameters(run).bound_words();
  };
  EXPECT_EQ(words({0.3, 0.5}), "");
  EXPECT_EQ(words({1.0}), "It stands at a bound: the bound decided how far, not the cost.");
  EXPECT_EQ(words({1.0, -1.0}),
            "All 2 that changed stand at a bound: the bounds decided how far, not the cost.");
  EXPECT_EQ(words({1.0, 0.5, 0.0}),
            "Of 2 parameters that changed 1 stands at a bound: there the bound decided how far, "
            "not the cost.");
}

}  // namespace
}  // namespace legwright
