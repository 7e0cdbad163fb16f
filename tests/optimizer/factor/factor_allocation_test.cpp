// SPDX-License-Identifier: Apache-2.0
// Counts calls of malloc, CHOLMOD's and Eigen's included; sanitizers bring a malloc of their own.
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>

#include "optimizer/factor/hessian_factor.hpp"
#include "tests/optimizer/factor/random_sparse.hpp"

#if defined(__GLIBC__) && !defined(LEGWRIGHT_SANITIZED)

namespace {
std::atomic<long> malloc_count{0};
}  // namespace

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* malloc(std::size_t size) {
  ++malloc_count;
  return __libc_malloc(size);
}
void* realloc(void* memory, std::size_t size) {
  ++malloc_count;
  return __libc_realloc(memory, size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++malloc_count;
  return __libc_calloc(count, size);
}
}

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::SparseMatrix;
using Eigen::VectorXd;

void expect_no_allocation(HessianFactor& factor) {
  const SparseMatrix<double> good = test::random_values(test::cyclic_pattern(12, 9), 1u);
  SparseMatrix<double> bad = good;
  bad.coeffRef(60, 60) *= -1.0;
  const VectorXd shift = VectorXd::Constant(good.rows(), 1e-3), b = shift;
  const MatrixXd many = b.replicate(1, 20);
  VectorXd x(b.size());
  MatrixXd solutions(many.rows(), many.cols());
  const auto round = [&] {
    return factor.factor(good, {}) && factor.solve(b, x) && !factor.factor(bad, {}) &&
           factor.factor(good, shift) && factor.solve(b, x);
  };
  const long before_all = malloc_count;
  ASSERT_TRUE(round() && factor.solve(many, solutions));
  EXPECT_GT(malloc_count, before_all) << "analysis allocates: the count works";
  const long before = malloc_count;
  const bool good_round = round();
  const long after = malloc_count;
  EXPECT_TRUE(good_round);
  EXPECT_EQ(after, before);
}

TEST(FactorAllocation, NoneAfterTheFirstFactor) {
  for (const CpuPath path : available_cpu_paths()) {
    HessianFactor factor(FactorMethod::supernodal, path);
    expect_no_allocation(factor);
  }
}

TEST(FactorAllocation, NoneForManyRightHandSidesAfterTheFirstTime) {
  HessianFactor factor;
  const SparseMatrix<double> a = test::random_values(test::cyclic_pattern(12, 9), 1u);
  const MatrixXd many = MatrixXd::Ones(a.rows(), 20);
  MatrixXd solutions(many.rows(), many.cols());
  ASSERT_TRUE(factor.factor(a, {}) && factor.solve(many, solutions));
  const long before = malloc_count;
  const bool solved = factor.solve(many, solutions);
  const long after = malloc_count;
  EXPECT_TRUE(solved);
  EXPECT_EQ(after, before);
}

}  // namespace
}  // namespace legwright

#endif
