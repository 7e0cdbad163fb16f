// SPDX-License-Identifier: Apache-2.0
// Our factorisation against CHOLMOD's simplicial one, on every path that this processor can run.
#include "optimizer/factor/supernodal_cholesky.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "optimizer/factor/hessian_factor.hpp"
#include "optimizer/objective/objective.hpp"
#include "tests/optimizer/factor/random_sparse.hpp"
#include "tests/support/puppy.hpp"
#include "tests/support/standing.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::SparseMatrix;
using Eigen::VectorXd;

std::string name_of_path(const testing::TestParamInfo<CpuPath>& path) {
  return std::string(to_string(path.param));
}

class SupernodalCholeskyTest : public testing::TestWithParam<CpuPath> {
 protected:
  HessianFactor ours{FactorMethod::supernodal, GetParam()}, reference{FactorMethod::simplicial};
};

INSTANTIATE_TEST_SUITE_P(AllPaths, SupernodalCholeskyTest, testing::ValuesIn(available_cpu_paths()),
                         name_of_path);

VectorXd some_vector(int size) {
  VectorXd b(size);
  for (int i = 0; i < size; ++i) b[i] = std::sin(1.0 + 2.7 * i);
  return b;
}

/// Largest difference of two solutions, each entry measured by its own row's scale 1/√a_ii.
double difference(const VectorXd& x, const VectorXd& y, const VectorXd& diagonal) {
  const VectorXd scale = diagonal.cwiseSqrt();
  return scale.cwiseProduct(x - y).norm() / scale.cwiseProduct(y).norm();
}

TEST_P(SupernodalCholeskyTest, AgreesWithCholmodOnRandomPatternsOfAnySize) {
  for (const int size : {1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 23, 24, 25, 33, 64, 65, 127, 200})
    for (const double density : {0.5, 2.0, 6.0, 400.0}) {
      const SparseMatrix<double> a =
          test::random_values(test::random_pattern(size, density, 11u * size), 5u);
      const VectorXd shift = 0.01 * a.diagonal(), b = some_vector(size);
      VectorXd x, y;
      ASSERT_TRUE(ours.factor(a, shift) && reference.factor(a, shift));
      ASSERT_TRUE(ours.solve(b, x) && reference.solve(b, y));
      EXPECT_LT(difference(x, y, a.diagonal()), 1e-12) << size << ", density " << density;
      EXPECT_LT(ours.residual(), 1e-14);
      ASSERT_TRUE(ours.factor(a, {}) && ours.solve(b, x));
      EXPECT_GT(difference(x, y, a.diagonal()), 1e-6) << "the shift must matter";
    }
}

TEST_P(SupernodalCholeskyTest, AgreesWithCholmodOnChainsOfKnots) {
  for (const int knots : {3, 5, 12, 24})
    for (const int block : {1, 4, 13, 31}) {
      const SparseMatrix<double> a = test::random_values(test::cyclic_pattern(knots, block), 5u);
      const VectorXd b = some_vector(static_cast<int>(a.rows()));
      VectorXd x, y;
      ASSERT_TRUE(ours.factor(a, {}) && reference.factor(a, {}));
      ASSERT_TRUE(ours.solve(b, x) && reference.solve(b, y));
      EXPECT_LT(difference(x, y, a.diagonal()), 1e-12) << knots << " knots of " << block;
    }
}

/// ∂G/∂m of the puppy at its initial guess, which is indefinite.
class PuppyHessian : public SupernodalCholeskyTest {
 protected:
  void take(bool trot) {
    const test::Puppy puppy = test::make_puppy(true);
    const Objective objective(puppy.morphology, puppy.space, test::make_sideways_task(trot));
    const VectorXd s = puppy.space.initial();
    hessian = objective.evaluate(s, test::standing_motion(objective, s), Order::hessian).hessian_mm;
    stiffness = objective.motion_units().cwiseAbs2().cwiseInverse();
  }
  SparseMatrix<double> hessian;
  VectorXd stiffness;  // 1/unit²
};

INSTANTIATE_TEST_SUITE_P(AllPaths, PuppyHessian, testing::ValuesIn(available_cpu_paths()),
                         name_of_path);

TEST_P(PuppyHessian, PatternWithRandomValues) {
  for (const bool trot : {false, true}) {
    take(trot);
    const SparseMatrix<double> a = test::random_values(hessian, 17u);
    const VectorXd b = some_vector(static_cast<int>(a.rows()));
    VectorXd x, y;
    ASSERT_TRUE(ours.factor(a, {}) && reference.factor(a, {}));
    ASSERT_TRUE(ours.solve(b, x) && reference.solve(b, y));
    EXPECT_LT(difference(x, y, a.diagonal()), 1e-12);
    MatrixXd many(b.size(), 20), solutions;
    for (int c = 0; c < many.cols(); ++c) many.col(c) = (c + 1.0) * b;
    ASSERT_TRUE(ours.solve(many, solutions));
    for (int c = 0; c < many.cols(); ++c)
      EXPECT_LT(difference(solutions.col(c), (c + 1.0) * y, a.diagonal()), 1e-12);
  }
}

TEST_P(PuppyHessian, IsFoundIndefiniteOrPositiveLikeByCholmod) {
  for (const bool trot : {false, true}) {
    take(trot);
    int positive = 0, refused = 0;
    for (double shift = 1e-4; shift < 1e4; shift *= 10.0) {
      const bool expected = reference.factor(hessian, shift * stiffness);
      ASSERT_EQ(ours.factor(hessian, shift * stiffness), expected) << "shift " << shift;
      EXPECT_EQ(ours.bad_pivot() < 0, expected);
      ++(expected ? positive : refused);
      if (!expected) continue;
      const VectorXd b = stiffness.cwiseProduct(some_vector(static_cast<int>(stiffness.size())));
      VectorXd x, y;
      ASSERT_TRUE(ours.solve(b, x) && reference.solve(b, y));
      EXPECT_LT(ours.residual(), 1e-13);
      // The condition number of this matrix is 1e8 and more.
      EXPECT_LT(difference(x, y, stiffness), 1e-9) << "shift " << shift;
    }
    EXPECT_GT(positive, 0);
    EXPECT_GT(refused, 0);
  }
}

TEST_P(SupernodalCholeskyTest, SameBitsWhateverWasFactoredBefore) {
  const SparseMatrix<double> a = test::random_values(test::cyclic_pattern(12, 11), 2u);
  const VectorXd b = some_vector(static_cast<int>(a.rows()));
  VectorXd x, y;
  ASSERT_TRUE(ours.factor(a, {}) && ours.solve(b, x));
  HessianFactor other(FactorMethod::supernodal, GetParam());
  SparseMatrix<double> bad = a;
  bad.coeffRef(70, 70) *= -1.0;
  ASSERT_FALSE(other.factor(bad, {}));  // leaves panels half done
  ASSERT_TRUE(other.factor(a, VectorXd::Constant(a.rows(), 1e300)));
  ASSERT_TRUE(other.factor(a, {}) && other.solve(b, y));
  EXPECT_EQ(x, y);
  bad = a;
  bad.coeffRef(70, 70) *= 1.0 + 1e-15;
  ASSERT_TRUE(other.factor(bad, {}) && other.solve(b, y));
  EXPECT_NE(x, y) << "the comparison must be able to fail";
}

TEST_P(SupernodalCholeskyTest, ABadPivotAnywhereStopsThere) {
  const SparseMatrix<double> good = test::random_values(test::cyclic_pattern(7, 5), 2u);
  for (int i = 0; i < good.rows(); ++i)
    for (const double factor : {-1.0, 0.0}) {
      SparseMatrix<double> a = good;
      a.coeffRef(i, i) *= factor;
      EXPECT_FALSE(ours.factor(a, {}));
      EXPECT_GE(ours.bad_pivot(), 0);
    }
  EXPECT_TRUE(ours.factor(good, {}));
}

TEST_P(SupernodalCholeskyTest, EntriesOfTheUpperTriangleAreMirrored) {
  const SymmetricPattern pattern{{0, 1, 3, 5}, {0, 0, 1, 1, 2}};  // (0, 1) and (1, 2)
  const double values[5 + 8] = {4.0, 1.0, 5.0, 2.0, 6.0};
  const Eigen::Vector3d diagonal(4.0, 5.0, 6.0);
  Eigen::Matrix3d full;
  full << 4, 1, 0, 1, 5, 2, 0, 2, 6;
  SupernodalCholesky cholesky(GetParam());
  cholesky.analyse(pattern);
  ASSERT_EQ(cholesky.factor(values, diagonal, VectorXd::Zero(3), 1e-14), -1);
  VectorXd x = VectorXd::Ones(3);
  cholesky.solve(x);
  EXPECT_LT((full * x - VectorXd::Ones(3)).norm(), 1e-14);
}

}  // namespace
}  // namespace legwright
