// SPDX-License-Identifier: Apache-2.0
// Equation (10)'s targets over the cycle, from task file to verdict: the puppy lifts its front feet
// as high as it is asked to, keeps its hind knees bent, and walks.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "tests/tools/verbs/program.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

class Style : public testing::Test, protected test::CallsInFolder {
 protected:
  /// Smallest and largest value of a column of result/motion.csv.
  std::pair<double, double> range(const std::string& column) const {
    std::istringstream table(read_file(folder_.path() / "run/result/motion.csv"));
    std::string line, cell;
    std::getline(table, line);
    std::istringstream head(line);
    int place = 0;
    while (std::getline(head, cell, ',') && cell != column) ++place;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    while (std::getline(table, line)) {
      std::istringstream row(line);
      for (int k = 0; k <= place; ++k) std::getline(row, cell, ',');
      low = std::min(low, std::stod(cell));
      high = std::max(high, std::stod(cell));
    }
    return {low, high};
  }
};

TEST_F(Style, PuppyLiftsItsFrontFeetHighAndWalks) {
  const std::string task = (test::kExamples / "puppy/high_step.toml").string();
  const test::Outcome optimize =
      call({"optimize", task, "--no-pictures", "--no-certificate", "--no-reasons", "-o", "run"});
  ASSERT_EQ(optimize.code, 0) << optimize.err;
  const test::Outcome validate = call({"validate", "run", "--quick"});
  EXPECT_EQ(validate.code, 0) << validate.out << validate.err;
  constexpr double kRadius = 0.012;  // of the feet [m]
  for (const char* foot : {"FL", "FR"})
    EXPECT_NEAR(range(std::string("foot:") + foot + "_z_m").second - kRadius, 0.05, 0.003) << foot;
  for (const char* foot : {"HL", "HR"}) {
    EXPECT_LT(range(std::string("foot:") + foot + "_z_m").second - kRadius, 0.03) << foot;
    const auto [low, high] = range(std::string("q:") + foot + "_knee_rad");
    EXPECT_NEAR(low, -1.0, 0.03) << foot;
    EXPECT_NEAR(high, -1.0, 0.03) << foot;
  }
}

}  // namespace
}  // namespace legwright
