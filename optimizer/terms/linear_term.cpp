// SPDX-License-Identifier: Apache-2.0
#include "optimizer/terms/linear_term.hpp"

#include <Eigen/LU>

namespace legwright {

void LinearTerm::add(int knot, int foot, std::initializer_list<Block> blocks,
                     const Eigen::VectorXd& target) {
  add(knot, foot, std::vector<Block>(blocks), target);
}

void LinearTerm::add(int knot, int foot, const std::vector<Block>& blocks,
                     const Eigen::VectorXd& target) {
  Element element{knot, foot, static_cast<int>(target.size()), {}};
  int columns = 0;
  for (const Block& block : blocks) columns += static_cast<int>(block.coefficient.cols());
  Eigen::MatrixXd coefficients(element.rows, columns);
  for (const Block& block : blocks) {
    const int size = static_cast<int>(block.coefficient.cols());
    coefficients.middleCols(static_cast<int>(element.slots.size()), size) = block.coefficient;
    for (int k = 0; k < size; ++k) element.slots.push_back(block.slot + k);
  }
  elements_.push_back(std::move(element));
  coefficients_.push_back(std::move(coefficients));
  targets_.push_back(target);
}

Eigen::VectorXd LinearTerm::sample(int element, std::mt19937& random) const {
  // Near r = 0 on either side: for an inequality that is both sides of the barrier's edge.
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd& C = coefficients_[element];
  Eigen::VectorXd z(C.cols());
  for (double& value : z) value = normal(random);
  Eigen::VectorXd wanted(C.rows());
  for (double& value : wanted) value = 0.05 * normal(random);
  const Eigen::VectorXd excess = C * z - targets_[element] - wanted;
  const Eigen::MatrixXd gram =
      C * C.transpose() + 1e-12 * Eigen::MatrixXd::Identity(C.rows(), C.rows());
  return z - C.transpose() * gram.inverse() * excess;
}

}  // namespace legwright
