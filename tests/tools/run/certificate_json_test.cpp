// SPDX-License-Identifier: Apache-2.0
#include "tools/run/certificate_json.hpp"

#include <gtest/gtest.h>

#include "tests/tools/run/solved_puppy.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

TEST(WorstConstraints, SayWhereWhenAndByHowMuch) {
  const test::SolvedPuppy good;
  const auto about_feet = [](const std::vector<std::string>& all) {
    int count = 0;
    for (const std::string& text : all) count += text.starts_with("foot position");
    return count;
  };
  EXPECT_EQ(about_feet(worst_constraints(good.objective, good.s, good.m, 3)), 0)
      << "a solved plan has its feet where its legs end";
  VectorXd bad = good.m;
  const int slot = good.objective.layout().foot(5, 2) - good.objective.layout().design_size() + 2;
  bad[slot] += 0.02;  // a foot 2 cm from where its leg is
  const std::vector<std::string> words = worst_constraints(good.objective, good.s, bad, 3);
  ASSERT_EQ(words.size(), 3u);
  const std::string& name = good.objective.morphology().feet[2].name;
  bool told = false;
  for (const std::string& text : words)
    told = told || (text.find(name) != std::string::npos && text.find("mm") != std::string::npos &&
                    text.find(" s, by") != std::string::npos);
  EXPECT_TRUE(told) << words[0] << "\n" << words[1] << "\n" << words[2];
}

}  // namespace
}  // namespace legwright
