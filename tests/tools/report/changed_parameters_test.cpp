// SPDX-License-Identifier: Apache-2.0
#include "tools/report/changed_parameters.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/text.hpp"

namespace legwright {
namespace {

ParameterRecord parameter(const char* name, double final) {
  return {name, "rad", "axis_angle", "", 0.0, -1.0, 1.0, final, 1};
}

PutBackRecord row(const char* parameter, double raised) {
  PutBackRecord out;
  out.parameter = parameter;
  out.F = raised;
  return out;
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

TEST(ChangedParameters, GoByWhatTheyBuyThenByTheirRange) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(kRun), (Names{"far", "half", "near"}));
  EXPECT_FALSE(changed_parameters(kRun).by_cost);
  RunRecord run = kRun;
  run.put_back = {row("near", 2.0), row("far", -0.5)};
  EXPECT_EQ(names(run), (Names{"near", "half", "far"})) << "what costs F comes last";
  EXPECT_TRUE(changed_parameters(run).by_cost);
  EXPECT_EQ(changed_parameters(run).list[0].lowered, 2.0);
  (*run.put_back)[1].J = 3.0;
  EXPECT_EQ(names(run)[0], "far") << "the body lowers F + J";
  run.put_back = {row("near", 2.0), row("half", std::numeric_limits<double>::quiet_NaN())};
  EXPECT_EQ(names(run)[0], "half") << "without it there is no motion";
  run.put_back.reset();
  EXPECT_FALSE(changed_parameters(run).by_cost) << "nothing is known";
  EXPECT_EQ(names(run), (Names{"far", "half", "near"}));
}

TEST(ChangedParameters, CountTheBoundsThatDecided) {
  const auto changed = [](const std::vector<double>& values) {
    RunRecord run;
    for (const double value : values) run.parameters.push_back(parameter("p", value));
    return changed_parameters(run);
  };
  EXPECT_EQ(changed({0.3, 0.5}).at_bound(), 0U);
  EXPECT_EQ(changed({0.3, 0.5}).bound_words(), "");
  EXPECT_EQ(changed({1.0}).at_bound(), 1U);
  EXPECT_TRUE(in_order(changed({1.0}).bound_words(), {"It stands", "the bound "}));
  EXPECT_EQ(changed({1.0, -1.0}).at_bound(), 2U);
  EXPECT_TRUE(in_order(changed({1.0, -1.0}).bound_words(), {"All 2", "stand ", "the bounds "}));
  const ChangedParameters some = changed({1.0, 0.5, 0.0});  // the last did not change
  EXPECT_EQ(some.at_bound(), 1U);
  EXPECT_EQ(some.list.size(), 2U);
  EXPECT_TRUE(in_order(some.bound_words(), {"2 parameters", "1 stands"}));
}

}  // namespace
}  // namespace legwright
