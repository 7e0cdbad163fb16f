// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/lbfgs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace legwright {
namespace {

constexpr double kLeastPairCurvature = 1e-10;  // sᵀy as a share of |s||y|

bool curved(const Eigen::VectorXd& step, const Eigen::VectorXd& change) {
  const double product = step.dot(change);
  return std::isfinite(product) && product > kLeastPairCurvature * step.norm() * change.norm();
}

}  // namespace

Lbfgs::Lbfgs(Eigen::VectorXd scale, int history)
    : scale_(std::move(scale)), history_(std::max(history, 1)) {}

bool Lbfgs::add(const Eigen::VectorXd& step, const Eigen::VectorXd& gradient_change) {
  Pair pair{step.cwiseQuotient(scale_), gradient_change.cwiseProduct(scale_)};
  if (!pair.step.allFinite() || !pair.change.allFinite() || !curved(pair.step, pair.change))
    return false;
  pairs_.push_back(std::move(pair));
  if (static_cast<int>(pairs_.size()) > history_) pairs_.pop_front();
  return true;
}

Eigen::VectorXd Lbfgs::direction(const Eigen::VectorXd& gradient,
                                 const std::vector<bool>& free) const {
  Eigen::VectorXd mask(gradient.size());
  for (int i = 0; i < mask.size(); ++i) mask[i] = free[i] ? 1.0 : 0.0;
  const Eigen::VectorXd g = gradient.cwiseProduct(scale_).cwiseProduct(mask);

  std::vector<Pair> used;  // newest first, what the free parameters saw of them
  for (auto pair = pairs_.rbegin(); pair != pairs_.rend(); ++pair) {
    Pair seen{pair->step.cwiseProduct(mask), pair->change.cwiseProduct(mask)};
    if (curved(seen.step, seen.change)) used.push_back(std::move(seen));
  }
  Eigen::VectorXd d = -g;
  std::vector<double> alpha(used.size());
  for (std::size_t k = 0; k < used.size(); ++k) {
    alpha[k] = used[k].step.dot(d) / used[k].step.dot(used[k].change);
    d -= alpha[k] * used[k].change;
  }
  if (!used.empty()) d *= used[0].step.dot(used[0].change) / used[0].change.squaredNorm();
  for (std::size_t k = used.size(); k-- > 0;) {
    const double beta = used[k].change.dot(d) / used[k].step.dot(used[k].change);
    d += (alpha[k] - beta) * used[k].step;
  }
  const bool descends = d.allFinite() && d.dot(g) < -1e-10 * d.norm() * g.norm();
  return (descends ? d : Eigen::VectorXd(-g)).cwiseProduct(scale_);
}

std::vector<bool> free_parameters(const Eigen::VectorXd& s, const Eigen::VectorXd& gradient,
                                  const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  std::vector<bool> free(s.size());
  for (int i = 0; i < s.size(); ++i) {
    const bool held = lower[i] >= upper[i] || (s[i] <= lower[i] && gradient[i] > 0.0) ||
                      (s[i] >= upper[i] && gradient[i] < 0.0);
    free[i] = !held;
  }
  return free;
}

double projected_gradient_norm(const Eigen::VectorXd& s, const Eigen::VectorXd& gradient,
                               const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                               const Eigen::VectorXd& scale) {
  const std::vector<bool> free = free_parameters(s, gradient, lower, upper);
  double norm = 0.0;
  for (int i = 0; i < s.size(); ++i)
    if (free[i]) norm = std::max(norm, std::abs(gradient[i] * scale[i]));
  return norm;
}

}  // namespace legwright
