// SPDX-License-Identifier: Apache-2.0
// The chain rule of one element against dense products.
#include "optimizer/objective/assembly.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

using Eigen::MatrixXd;

/// Local variable 0 is column 4 of the clique; the eight others are a block that depends on columns
/// 0 … 2 and 5 … 8.
class CurvatureOfAnElement : public testing::Test {
 protected:
  CurvatureOfAnElement() {
    std::srand(1);
    chain_ = {MatrixXd::Random(7, 8)};
    auto plan = std::make_shared<ElementPlan>();
    plan->direct = {{0, 4}};
    plan->through = {{1, 8, {{0, 0, 3}, {3, 5, 4}}}};
    element_ = {plan, {0}};
    local_.setZero(9, 9);
    local_(0, 4) = 1.0;
    local_.block(1, 0, 8, 3) = chain_[0].topRows(3).transpose();
    local_.block(1, 5, 8, 4) = chain_[0].bottomRows(4).transpose();
  }

  void expect_dense_product(const MatrixXd& curvature, int columns) const {
    ElementWorkspace workspace;
    workspace.curvature = curvature;
    workspace.hessian.setZero(columns, columns);
    expand_curvature(element_, chain_, columns, workspace);
    const MatrixXd E = local_.leftCols(columns);
    const MatrixXd error = workspace.hessian - E.transpose() * curvature * E;
    EXPECT_LT(MatrixXd(error.triangularView<Eigen::Lower>()).cwiseAbs().maxCoeff(), 1e-14);
  }

  std::vector<MatrixXd> chain_;  // columns × size
  PlannedElement element_;
  MatrixXd local_;  // local variables × columns of the clique
};

TEST_F(CurvatureOfAnElement, IsTheDenseProductWhereItIsFull) {
  const MatrixXd half = MatrixXd::Random(9, 9);
  expect_dense_product(half + half.transpose(), 9);
  expect_dense_product(half + half.transpose(), 5);  // as without the design
}

TEST_F(CurvatureOfAnElement, IsTheDenseProductWhereItIsSparse) {
  MatrixXd sparse = MatrixXd::Zero(9, 9);
  sparse(0, 2) = sparse(2, 0) = 0.7;
  sparse(3, 3) = -0.4;
  sparse(5, 8) = sparse(8, 5) = 1.3;
  expect_dense_product(sparse, 9);
  expect_dense_product(sparse, 5);
}

}  // namespace
}  // namespace legwright
