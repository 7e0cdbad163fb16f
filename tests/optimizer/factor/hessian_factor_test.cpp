// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/hessian_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/optimizer/solve/toy_cost.hpp"
#include "tests/support/not_finite.hpp"

namespace legwright {
namespace {

using test::kInfinity;
using test::kNan;

using Eigen::MatrixXd;
using Eigen::SparseMatrix;
using Eigen::VectorXd;

/// Sparse, diagonally dominant, with entries far from the diagonal; scaled by rows and columns like
/// motion.
MatrixXd arrow_band(int size) {
  MatrixXd a = MatrixXd::Zero(size, size);
  for (int i = 0; i < size; ++i) {
    a(i, i) = 6.0 + 0.1 * i;
    if (i + 2 < size) a(i + 2, i) = a(i, i + 2) = 1.0 - 0.03 * i;
    if (i > 0) a(i, 0) = a(0, i) = 0.2;
  }
  const VectorXd scale = VectorXd::LinSpaced(size, 1.0, 100.0);
  return scale.asDiagonal() * a * scale.asDiagonal();
}

SparseMatrix<double> sparse_lower(const MatrixXd& full) {
  return MatrixXd(full.triangularView<Eigen::Lower>()).sparseView();
}

/// One way to factor on this machine.
struct Way {
  FactorMethod method;
  CpuPath path;
  HessianFactor make() const { return HessianFactor(method, path); }
};

std::string name(const testing::TestParamInfo<Way>& way) {
  return std::string(way.param.method == FactorMethod::simplicial ? to_string(way.param.method)
                                                                  : to_string(way.param.path));
}

std::vector<Way> all_ways() {
  std::vector<Way> ways = {{FactorMethod::simplicial, CpuPath::baseline}};
  for (const CpuPath path : available_cpu_paths()) ways.push_back({FactorMethod::supernodal, path});
  return ways;
}

class HessianFactorTest : public testing::TestWithParam<Way> {
 protected:
  HessianFactor factor = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(AllWays, HessianFactorTest, testing::ValuesIn(all_ways()), name);

TEST_P(HessianFactorTest, SolvesShiftedSystemLikeDenseReference) {
  const int size = 40;
  const MatrixXd a = arrow_band(size);
  const VectorXd shift = VectorXd::LinSpaced(size, 0.0, 3.0),
                 b = VectorXd::LinSpaced(size, -1.0, 2.0);
  ASSERT_TRUE(factor.factor(sparse_lower(a), shift));
  VectorXd x;
  ASSERT_TRUE(factor.solve(b, x));
  const VectorXd expected = (a + MatrixXd(shift.asDiagonal())).ldlt().solve(b);
  EXPECT_LT((x - expected).norm(), 1e-12 * expected.norm());
  EXPECT_LT(factor.residual(), 1e-13);
  EXPECT_EQ(factor.bad_pivot(), -1);
  EXPECT_GT((x - a.ldlt().solve(b)).norm(), 1e-6 * expected.norm()) << "the shift must matter";
}

TEST_P(HessianFactorTest, NamesANegativePivotAndRefusesToSolve) {
  MatrixXd a = arrow_band(12);
  a(3, 3) *= -1.0;
  a(7, 7) *= -1.0;
  EXPECT_FALSE(factor.factor(sparse_lower(a), {}));
  EXPECT_FALSE(factor.positive());
  EXPECT_TRUE(factor.bad_pivot() == 3 || factor.bad_pivot() == 7) << factor.bad_pivot();
  VectorXd x;
  EXPECT_FALSE(factor.solve(VectorXd::Ones(12), x));
  EXPECT_EQ(x, VectorXd::Zero(12));
}

TEST_P(HessianFactorTest, IndefiniteWithPositiveDiagonalIsNoticed) {
  MatrixXd a(2, 2);
  a << 1.0, 2.0, 2.0, 1.0;
  EXPECT_FALSE(factor.factor(sparse_lower(a), {}));
  EXPECT_GE(factor.bad_pivot(), 0);
  EXPECT_TRUE(factor.factor(sparse_lower(a), VectorXd::Constant(2, 1.5)));
  EXPECT_EQ(factor.bad_pivot(), -1);
}

TEST_P(HessianFactorTest, SingularMatrixIsNotPositiveUntilShifted) {
  const int size = 9;
  MatrixXd a = MatrixXd::Zero(size, size);  // a free chain of springs: rank n − 1
  for (int i = 0; i + 1 < size; ++i) {
    const double stiffness = 1.0 / 3.0 + i;
    a(i, i) += stiffness;
    a(i + 1, i + 1) += stiffness;
    a(i + 1, i) = a(i, i + 1) = -stiffness;
  }
  EXPECT_FALSE(factor.factor(sparse_lower(a), {}));
  EXPECT_TRUE(factor.factor(sparse_lower(a), VectorXd::Constant(size, 1e-6)));
  EXPECT_FALSE(factor.factor(sparse_lower(MatrixXd::Zero(3, 3) + MatrixXd::Identity(3, 3)),
                             -VectorXd::Ones(3)));
}

TEST_P(HessianFactorTest, RefusesWhatIsNotFinite) {
  const SparseMatrix<double> good = sparse_lower(arrow_band(6));
  VectorXd x;
  for (const double poison : {kNan, kInfinity, -kInfinity}) {
    for (int k = 0; k < good.nonZeros(); ++k) {
      SparseMatrix<double> bad = good;
      bad.valuePtr()[k] = poison;
      EXPECT_FALSE(factor.factor(bad, {})) << "entry " << k << " = " << poison;
      EXPECT_FALSE(factor.solve(VectorXd::Ones(6), x));
    }
    VectorXd shift = VectorXd::Zero(6);
    shift[4] = poison;
    EXPECT_FALSE(factor.factor(good, shift));
    ASSERT_TRUE(factor.factor(good, {}));
    VectorXd b = VectorXd::Ones(6);
    b[2] = poison;
    EXPECT_FALSE(factor.solve(b, x));
    EXPECT_TRUE(x.allFinite());
  }
  EXPECT_FALSE(factor.factor(good, VectorXd::Ones(5))) << "shift of the wrong size";
}

TEST_P(HessianFactorTest, OverflowInsideIsNotSuccess) {
  MatrixXd a = MatrixXd::Identity(2, 2) * 1e-300;
  a(1, 0) = a(0, 1) = 1e300;
  EXPECT_FALSE(factor.factor(sparse_lower(a), {}));
}

TEST_P(HessianFactorTest, FollowsANewPatternAndAddsAMissingDiagonal) {
  ASSERT_TRUE(factor.factor(sparse_lower(arrow_band(8)), {}));
  MatrixXd hollow = MatrixXd::Zero(3, 3);
  hollow(2, 0) = hollow(0, 2) = 1.0;
  const SparseMatrix<double> lower = sparse_lower(hollow);
  ASSERT_EQ(lower.nonZeros(), 1);
  EXPECT_FALSE(factor.factor(lower, {}));
  ASSERT_TRUE(factor.factor(lower, VectorXd::Constant(3, 2.0)));
  VectorXd x;
  ASSERT_TRUE(factor.solve(VectorXd::Ones(3), x));
  EXPECT_LT((x - Eigen::Vector3d(1.0 / 3.0, 0.5, 1.0 / 3.0)).norm(), 1e-15);
}

TEST_P(HessianFactorTest, SameBitsTwiceAndAfterAMove) {
  const SparseMatrix<double> a = sparse_lower(arrow_band(30));
  const VectorXd b = VectorXd::LinSpaced(30, 0.0, 1.0);
  HessianFactor first = GetParam().make(), second = GetParam().make();
  VectorXd x, y;
  ASSERT_TRUE(first.factor(a, {}) && first.solve(b, x));
  ASSERT_FALSE(second.factor(a, VectorXd::Constant(30, -1e9)));  // another history, same answer
  ASSERT_TRUE(second.factor(a, {}));
  HessianFactor moved = std::move(second);
  ASSERT_TRUE(moved.solve(b, y));
  EXPECT_EQ(x, y);
}

TEST_P(HessianFactorTest, NothingCanBeSolvedBeforeAFactorisation) {
  VectorXd x;
  EXPECT_FALSE(factor.positive());
  EXPECT_FALSE(factor.solve(VectorXd::Ones(3), x));
}

TEST_P(HessianFactorTest, SolvesManyRightHandSidesLikeOneByOne) {
  for (const int count : {1, 2, 7, 20, 53}) {
    const int size = 37;
    MatrixXd b(size, count), x;
    for (int c = 0; c < count; ++c) b.col(c) = VectorXd::LinSpaced(size, c - 3.0, 2.0 * c);
    ASSERT_TRUE(factor.factor(sparse_lower(arrow_band(size)), VectorXd::Constant(size, 0.5)));
    ASSERT_TRUE(factor.solve(b, x));
    EXPECT_LT(factor.residual(), 1e-13);
    ASSERT_EQ(x.cols(), count);
    for (int c = 0; c < count; ++c) {
      VectorXd alone;
      ASSERT_TRUE(factor.solve(VectorXd(b.col(c)), alone));
      EXPECT_LE((x.col(c) - alone).norm(), 1e-13 * alone.norm()) << "column " << c;
    }
    b(5, count - 1) = kNan;
    EXPECT_FALSE(factor.solve(b, x));
    EXPECT_EQ(x, MatrixXd::Zero(size, count));
  }
}

TEST_P(HessianFactorTest, AnEmptyMatrixIsPositive) {
  EXPECT_TRUE(factor.factor(SparseMatrix<double>(0, 0), {}));
  VectorXd x;
  EXPECT_TRUE(factor.solve(VectorXd(), x));
}

TEST(FactorMethod, IsTakenFromTheEnvironment) {
  ASSERT_EQ(setenv("LEGWRIGHT_FACTOR", "simplicial", 1), 0);
  EXPECT_EQ(factor_method(), FactorMethod::simplicial);
  EXPECT_EQ(factor_name(), "simplicial");
  ASSERT_EQ(setenv("LEGWRIGHT_FACTOR", "simplical", 1), 0);
  EXPECT_THROW(HessianFactor(), std::invalid_argument);
  ASSERT_EQ(unsetenv("LEGWRIGHT_FACTOR"), 0);
  EXPECT_EQ(factor_method(), FactorMethod::supernodal);
  EXPECT_EQ(factor_name(), to_string(cpu_path()));
}

}  // namespace
}  // namespace legwright
