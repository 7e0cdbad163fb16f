// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/joint_search.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

using Eigen::VectorXd;

VectorXd design(double value) { return VectorXd::Constant(2, value); }

/// Designs 0 … 4, with the F that is given.
JointNewtonResult path_of(const std::vector<double>& values) {
  JointNewtonResult out;
  for (std::size_t k = 0; k < values.size(); ++k)
    out.path.push_back({design(static_cast<double>(k)), {}, values[k]});
  return out;
}

std::vector<double> values_of(const std::vector<JointPoint>& points) {
  std::vector<double> out;
  for (const JointPoint& point : points) out.push_back(point.value);
  return out;
}

TEST(LastPoints, HaveLessFThanTheRunBeforeThem) {
  const JointNewtonResult found = path_of({90.0, 50.0, 20.0, 8.0, 3.0});
  EXPECT_EQ(values_of(last_points(found, 30.0, design(0.0), 9)),
            (std::vector<double>{20.0, 8.0, 3.0}));
  EXPECT_TRUE(last_points(found, 3.0, design(0.0), 9).empty());
}

TEST(LastPoints, ChangeTheDesign) {
  const JointNewtonResult found = path_of({9.0, 8.0, 7.0});
  EXPECT_EQ(values_of(last_points(found, 30.0, design(1.0), 9)), (std::vector<double>{9.0, 7.0}));
}

TEST(LastPoints, AreAtMostSoManyAndTheLast) {
  const JointNewtonResult found = path_of({9.0, 8.0, 7.0, 6.0});
  EXPECT_EQ(values_of(last_points(found, 30.0, design(-1.0), 1)), (std::vector<double>{6.0}));
  EXPECT_EQ(last_points(found, 30.0, design(-1.0), 4).size(), 4u);
}

}  // namespace
}  // namespace legwright
