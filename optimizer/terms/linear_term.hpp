// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <vector>

#include "optimizer/terms/term.hpp"

namespace legwright {

/// A term whose residuals are linear in their local variables, r = Σ coefficient · z − target. Most
/// terms are: what bends is in the kinematics, whose outputs have slots of their own.
class LinearTerm : public Term {
 public:
  void residual(int element, const Eigen::VectorXd& z, Eigen::VectorXd& r) const override {
    r.noalias() = coefficients_[element] * z;
    r -= targets_[element];
  }
  void jacobian(int element, const Eigen::VectorXd&, Eigen::MatrixXd& jacobian) const override {
    jacobian = coefficients_[element];
  }
  bool curved() const override { return false; }
  const Eigen::MatrixXd* constant_jacobian(int element) const override {
    return &coefficients_[element];
  }
  Eigen::VectorXd sample(int element, std::mt19937& random) const override;

 protected:
  /// A block of consecutive slots and what it is multiplied by (rows × block size).
  struct Block {
    int slot;
    Eigen::MatrixXd coefficient;
  };
  /// Blocks of one element must not overlap.
  void add(int knot, int foot, std::initializer_list<Block> blocks, const Eigen::VectorXd& target);
  void add(int knot, int foot, const std::vector<Block>& blocks, const Eigen::VectorXd& target);

  /// scale · identity.
  static Eigen::MatrixXd times(double scale, int size = 3) {
    return scale * Eigen::MatrixXd::Identity(size, size);
  }

 private:
  std::vector<Eigen::MatrixXd> coefficients_;
  std::vector<Eigen::VectorXd> targets_;
};

}  // namespace legwright
