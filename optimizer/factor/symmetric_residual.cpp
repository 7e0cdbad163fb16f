// SPDX-License-Identifier: Apache-2.0
#include "optimizer/factor/symmetric_residual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace legwright {

void SymmetricResidual::analyse(const SymmetricPattern& pattern) {
  constexpr int kBeyondEnd = 8;  // numbers that kernels may read beyond an end
  size_ = pattern.size();
  run_start_ = {0};
  runs_.clear();
  diagonal_.clear();
  for (int j = 0; j < size_; ++j) {
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k) {
      const int row = pattern.rows[k];
      const bool first = static_cast<int>(runs_.size()) == run_start_.back();
      if (row == j)
        diagonal_.push_back({j, k});
      else if (!first && runs_.back().row + runs_.back().length == row &&
               runs_.back().value + runs_.back().length == k)
        ++runs_.back().length;
      else
        runs_.push_back({row, 1, k});
    }
    run_start_.push_back(static_cast<int>(runs_.size()));
  }
  for (Eigen::VectorXd* v : {&x_, &remainder_, &magnitude_}) v->setZero(size_ + kBeyondEnd);
}

void SymmetricResidual::diagonal(const double* values, Eigen::VectorXd& out) const {
  out.setZero(size_);
  for (const Diagonal& entry : diagonal_) out[entry.unknown] += values[entry.value];
}

double SymmetricResidual::backward_error(const double* values, const Eigen::VectorXd& diagonal,
                                         const Eigen::VectorXd& b, const Eigen::VectorXd& x) {
  x_.head(size_) = x;
  remainder_.setZero();
  remainder_.head(size_) = b - diagonal.cwiseProduct(x);
  magnitude_.setZero();
  magnitude_.head(size_) = b.cwiseAbs() + diagonal.cwiseProduct(x).cwiseAbs();
  kernels_->subtract_symmetric(size_, run_start_.data(), runs_.data(), values, x_.data(),
                               remainder_.data(), magnitude_.data());
  double worst = 0.0;
  for (int i = 0; i < size_; ++i) {
    if (!std::isfinite(remainder_[i]) || !std::isfinite(magnitude_[i]))
      return std::numeric_limits<double>::infinity();
    if (magnitude_[i] > 0.0) worst = std::max(worst, std::abs(remainder_[i]) / magnitude_[i]);
  }
  return worst;
}

}  // namespace legwright
