// SPDX-License-Identifier: Apache-2.0
#include "tools/run/pull.hpp"

#include <algorithm>
#include <cmath>

namespace legwright {
namespace {

constexpr double kTold = 0.01;  // of the largest share

/// Long steps bend: what a term really gave up goes to the parameters in the ratio of their shares.
/// @return the size of the rest that the shares did not tell
double spread_rest(double decrease, Eigen::MatrixXd::RowXpr shares) {
  const double size = shares.cwiseAbs().sum(), rest = decrease - shares.sum();
  if (size > 0.0) shares += rest / size * shares.cwiseAbs();
  return std::abs(rest);
}

}  // namespace

void PullAlongPath::add(const Objective& objective, const Eigen::VectorXd& s,
                        const Eigen::VectorXd& m, const Eigen::MatrixXd& sensitivity) {
  TermShares now = objective.shares(s, m, sensitivity.size() > 0);
  if (sensitivity.size() > 0) now.partial_s += now.stationarity * sensitivity;
  if (decrease_.size() == 0) decrease_.setZero(now.partial_s.rows(), now.partial_s.cols());
  std::vector<double> values;
  for (const TermValue& term : objective.terms(s, m)) values.push_back(term.value);
  if (share_.size() > 0) {
    const Eigen::RowVectorXd change = (s - s_).transpose();
    Eigen::MatrixXd step = -0.5 * (share_ + now.partial_s) * change.asDiagonal();
    for (int t = 0; t < step.rows(); ++t)
      spread_ += spread_rest(values_[t] - values[t], step.row(t));
    decrease_ += step;
  }
  values_ = std::move(values);
  terms_ = std::move(now.names);
  share_ = std::move(now.partial_s);
  s_ = s;
}

void PullAlongPath::follow(const PullAlongPath& before) {
  if (decrease_.size() == 0)
    decrease_ = before.decrease_;
  else if (before.decrease_.size() > 0)
    decrease_ += before.decrease_;
  if (terms_.empty()) terms_ = before.terms_;
  spread_ += before.spread_;
}

Json PullAlongPath::to_json(const DesignSpace& space, double weight) const {
  Json result = Json::object();
  const double largest = decrease_.size() > 0 ? decrease_.cwiseAbs().maxCoeff() : 0.0;
  for (int k = 0; k < decrease_.cols(); ++k) {
    std::vector<int> order;
    for (int t = 0; t < decrease_.rows(); ++t)
      if (std::abs(decrease_(t, k)) > kTold * largest) order.push_back(t);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      return std::abs(decrease_(a, k)) > std::abs(decrease_(b, k));
    });
    Json terms = Json::object();
    for (int t : order) terms[std::string(terms_[t])] = weight * decrease_(t, k);
    result[space.parameters[k].name] = terms;
  }
  return result;
}

}  // namespace legwright
