// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/reduced_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

#include "optimizer/solve/lbfgs.hpp"

namespace legwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Curvatures below this share of the largest one are rounding: a step along them would be a guess.
constexpr double kLeastModelCurvature = 1e-6;

/// −|H|⁻¹ g, with |H| from the eigenvalues' absolute values.
VectorXd downhill(const MatrixXd& hessian, const VectorXd& gradient) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(hessian);
  VectorXd curvature = eigen.eigenvalues().cwiseAbs();
  const double floor = std::max(kLeastModelCurvature * curvature.maxCoeff(), 1e-300);
  curvature = curvature.cwiseMax(floor);
  return -(eigen.eigenvectors() *
           (eigen.eigenvectors().transpose() * gradient).cwiseQuotient(curvature));
}

}  // namespace

VectorXd reduced_newton_step(const MatrixXd& hessian, const VectorXd& gradient, const VectorXd& s,
                             const DesignBox& box, double largest_change) {
  const int n = static_cast<int>(s.size());
  VectorXd step = VectorXd::Zero(n);  // in natural units
  if (!hessian.allFinite() || !gradient.allFinite()) return step;
  const MatrixXd h = box.scale.asDiagonal() * hessian * box.scale.asDiagonal();
  const VectorXd g = gradient.cwiseProduct(box.scale);
  const VectorXd low = (box.lower - s).cwiseQuotient(box.scale).cwiseMax(-largest_change);
  const VectorXd high = (box.upper - s).cwiseQuotient(box.scale).cwiseMin(largest_change);
  std::vector<bool> free = free_parameters(s, gradient, box.lower, box.upper);
  for (int round = 0; round < n; ++round) {
    std::vector<int> index;
    for (int i = 0; i < n; ++i)
      if (free[i]) index.push_back(i);
    if (index.empty()) break;
    VectorXd held = step;
    for (int i : index) held[i] = 0.0;
    const VectorXd slope = g + h * held;
    const VectorXd p = downhill(h(index, index), slope(index));
    bool inside = true;
    for (std::size_t k = 0; k < index.size(); ++k) {
      const int i = index[k];
      step[i] = p[static_cast<int>(k)];
      const bool past = step[i] < low[i] || step[i] > high[i];
      if (!past) continue;
      step[i] = std::clamp(step[i], low[i], high[i]);
      free[i] = false;
      inside = false;
    }
    if (inside) break;
  }
  return step.cwiseMax(low).cwiseMin(high).cwiseProduct(box.scale);
}

VectorXd steepest_step(const MatrixXd& hessian, const VectorXd& gradient, const VectorXd& s,
                       const DesignBox& box, double largest_change) {
  VectorXd g = gradient.cwiseProduct(box.scale);
  const std::vector<bool> free = free_parameters(s, gradient, box.lower, box.upper);
  for (int i = 0; i < g.size(); ++i)
    if (!free[static_cast<std::size_t>(i)]) g[i] = 0.0;
  const double largest = g.lpNorm<Eigen::Infinity>();
  if (!(largest > 0.0)) return VectorXd::Zero(s.size());
  const VectorXd low = (box.lower - s).cwiseQuotient(box.scale).cwiseMax(-largest_change);
  const VectorXd high = (box.upper - s).cwiseQuotient(box.scale).cwiseMin(largest_change);
  const VectorXd whole = (-g * (largest_change / largest)).cwiseMax(low).cwiseMin(high);
  const VectorXd step = whole.cwiseProduct(box.scale);
  const double slope = gradient.dot(step), curvature = step.dot(hessian * step);
  return curvature > 0.0 ? std::min(1.0, -slope / curvature) * step : step;
}

double model_change(const MatrixXd& hessian, const VectorXd& gradient, const VectorXd& step) {
  return gradient.dot(step) + 0.5 * step.dot(hessian * step);
}

}  // namespace legwright
