// SPDX-License-Identifier: Apache-2.0
#include "tools/run/pull.hpp"

#include <gtest/gtest.h>

#include "tests/tools/run/solved_puppy.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

TEST(Pull, SharesOfAllTermsMakeTheDecreaseOfF) {
  const test::SolvedPuppy from;
  const auto sensitivity = [&](const VectorXd& s, const VectorXd& m) {
    const Evaluation at = from.objective.evaluate(s, m, Order::design);
    HessianFactor factor;
    EXPECT_TRUE(factor.factor(at.hessian_mm, {}));
    Eigen::MatrixXd x;
    EXPECT_TRUE(factor.solve(at.hessian_ms, x));
    return Eigen::MatrixXd(-x);
  };
  VectorXd s = from.s, m = from.m;
  s[6] += 0.004;
  s[18] *= 1.004;
  ASSERT_EQ(newton(from.objective, s, m, {.tolerance = 1e-8, .max_iterations = 100}).status,
            SolveStatus::converged);
  PullAlongPath pull;
  pull.add(from.objective, from.s, from.m, sensitivity(from.s, from.m));
  EXPECT_EQ(pull.decrease().norm(), 0.0);
  pull.add(from.objective, s, m, sensitivity(s, m));
  const double fallen = from.objective.evaluate(from.s, from.m, Order::value).value -
                        from.objective.evaluate(s, m, Order::value).value;
  EXPECT_GT(std::abs(fallen), 1e-3);
  EXPECT_NEAR(pull.decrease().sum(), fallen, 1e-9 * std::abs(fallen));
  EXPECT_LT(pull.spread(), 1e-2 * std::abs(fallen)) << "derivatives along m*(s) tell nearly all";
  // Only what was changed has a share.
  for (int k = 0; k < pull.decrease().cols(); ++k) {
    if (k != 6 && k != 18) {
      EXPECT_EQ(pull.decrease().col(k).norm(), 0.0) << k;
    }
  }
  const Json told = pull.to_json(from.problem.robot.space, 1.0);
  EXPECT_FALSE(told[from.problem.robot.space.parameters[6].name].empty());
  // Without dm/ds the shares are those at fixed m, and miss what the motion makes of them.
  PullAlongPath fixed;
  fixed.add(from.objective, from.s, from.m, {});
  fixed.add(from.objective, s, m, {});
  EXPECT_GT((fixed.decrease() - pull.decrease()).norm(), 0.1 * pull.decrease().norm());
}

}  // namespace
}  // namespace legwright
