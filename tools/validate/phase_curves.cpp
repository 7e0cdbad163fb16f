// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/phase_curves.hpp"

#include <algorithm>

namespace legwright {

PhaseCurves::PhaseCurves(int quantities, int bins)
    : sums_(Eigen::MatrixXd::Zero(quantities, bins)), counts_(Eigen::VectorXi::Zero(bins)) {}

void PhaseCurves::add(int bin, const Eigen::VectorXd& values) {
  sums_.col(bin) += values;
  ++counts_[bin];
}

void PhaseCurves::end_cycle(bool keep, const std::function<void(Eigen::MatrixXd&)>& derive) {
  if (keep) {
    Eigen::MatrixXd means = sums_;
    for (Eigen::Index bin = 0; bin < means.cols(); ++bin)
      means.col(bin) /= std::max(1, counts_[bin]);
    if (derive) derive(means);
    if (cycles_ == 0) {
      totals_ = lows_ = highs_ = means;
    } else {
      totals_ += means;
      lows_ = lows_.cwiseMin(means);
      highs_ = highs_.cwiseMax(means);
    }
    ++cycles_;
  }
  sums_.setZero();
  counts_.setZero();
}

Curve PhaseCurves::curve(int quantity) const {
  return {std::nullopt, totals_.row(quantity) / cycles_, lows_.row(quantity), highs_.row(quantity)};
}

}  // namespace legwright
