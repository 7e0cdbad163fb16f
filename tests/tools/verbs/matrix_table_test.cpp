// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/matrix_table.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

TEST(MatrixTable, KeepsItsColumnsWithNamesOfAnyLength) {
  MatrixRecord matrix;
  const std::string longest = "carries-a-load-sideways-uphill";
  matrix.designs = {{"initial body", "initial"}, {"for " + longest + " alone", longest}};
  matrix.cells.of("trot") = {{1.5, true, "", {}}, {-1.234e-12, false, "", {}}};
  matrix.cells.of(longest) = {{0.25, false, "", {}}, {12345678.0, true, "", {}}};
  const std::string name = "  body for " + longest + " alone";
  const auto line = [&](std::string body, const std::string& one, const std::string& other) {
    body.resize(name.size(), ' ');
    return body + "  " + std::string(18 - one.size(), ' ') + one + "  " +
           std::string(longest.size() - other.size(), ' ') + other + "\n";
  };
  EXPECT_EQ(matrix_table(matrix), line("F and verdict at three gains", "trot", longest) +
                                      line("  body initial body", "1.5   PASS", "0.25   FAIL") +
                                      line(name, "-1.234e-12   FAIL", "1.235e+07   PASS"));
}

}  // namespace
}  // namespace legwright
