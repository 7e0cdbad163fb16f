// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/certificate.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "optimizer/base/parallel.hpp"
#include "optimizer/solve/adjoint.hpp"
#include "optimizer/solve/lbfgs.hpp"
#include "optimizer/solve/newton.hpp"
#include "optimizer/solve/predictor.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr int kChordSteps = 8;
constexpr double kChordGain = 0.5;  // a step that leaves more of G is the last
constexpr double kUnseen = 1e-6;    // of the gradient: what is left to fall changes no difference
constexpr double kLeastLargest = 1e-3;  // at a minimum there is nothing left to compare with

class TaskProof {
 public:
  TaskProof(const WeightedCost& task, const VectorXd& scale, const CertificateOptions& options)
      : task_(task), scale_(scale), options_(options) {}

  TaskCertificate run(const VectorXd& s, const TaskIterate& iterate) {
    proof_.motion_status = iterate.motion_status;
    task_.cost->evaluate(s, iterate.m, Order::design, at_);
    proof_.stationarity = scaled_norm(at_.stationarity);
    VectorXd dJ_dm = at_.stationarity, partial_s = at_.partial_s;
    if (task_.outer) {
      Evaluation outer;
      task_.outer->evaluate(s, iterate.m, Order::gradients, outer);
      dJ_dm += outer.stationarity;
      partial_s += outer.partial_s;
    }
    const AdjointResult result =
        legwright::adjoint(factor_, at_.hessian_mm, dJ_dm, at_.hessian_ms, partial_s);
    proof_.minimum_in_motion = result.status == SolveStatus::converged;
    if (!proof_.minimum_in_motion) return proof_;
    proof_.adjoint_residual = result.residual;
    proof_.adjoint = result.dJ_ds;
    proof_.largest = result.dJ_ds.cwiseProduct(scale_).lpNorm<Eigen::Infinity>();
    differentiate(s, iterate.m);
    return proof_;
  }

 private:
  void differentiate(const VectorXd& s, const VectorXd& m) {
    const int n = static_cast<int>(s.size());
    proof_.difference.setZero(n);
    proof_.resolved = true;
    for (int k = 0; k < n; ++k) {
      const double h = options_.step * scale_[k];
      proof_.difference[k] = (value_at(s, m, k, h) - value_at(s, m, k, -h)) / (2.0 * h);
    }
    proof_.error = (proof_.adjoint - proof_.difference).cwiseProduct(scale_).cwiseAbs();
  }

  /// F + J at the motion that belongs to s with one parameter moved.
  double value_at(const VectorXd& s, const VectorXd& m, int parameter, double change) {
    VectorXd moved = s, motion;
    moved[parameter] += change;
    (void)predict(factor_, m, at_.stationarity, at_.hessian_ms, moved - s, motion);
    double value = 0.0;
    proof_.resolved =
        (rest_by_chord(moved, motion, value) || solve(moved, motion, value)) && proof_.resolved;
    if (!task_.outer) return value;
    Evaluation outer;
    task_.outer->evaluate(moved, motion, Order::value, outer);
    return value + outer.value;
  }

  /// Chord method: Newton's steps with the factor at the unmoved design, which lies so near that
  /// one or two bring the motion to rest. It only asks for G, a fraction of the price of ∂G/∂m.
  /// Stiff terms may keep G above the tolerance by rounding alone: where it no longer falls, the
  /// motion rests if what F can still fall by, ½ Gᵀ(∂G/∂m)⁻¹G, would not be seen in the difference.
  bool rest_by_chord(const VectorXd& s, VectorXd& motion, double& value) {
    VectorXd trial = motion, step;
    double least = std::numeric_limits<double>::infinity(), left = least;
    for (int k = 0; k <= kChordSteps; ++k) {
      task_.cost->evaluate(s, trial, Order::gradient, there_);
      const double now = scaled_norm(there_.stationarity);
      const bool falls = now < kChordGain * least;
      if (now < least) {
        least = now;
        motion = trial;
        value = there_.value;
      }
      if (least < options_.tolerance) return true;
      if (!factor_.solve(-there_.stationarity, step)) return false;
      left = std::min(left, 0.5 * std::abs(there_.stationarity.dot(step)));
      if (!falls) break;
      trial += step;
    }
    return left < kUnseen * options_.step * std::max(proof_.largest, kLeastLargest);
  }

  double scaled_norm(const VectorXd& g) const {
    return g.cwiseProduct(task_.cost->motion_units()).lpNorm<Eigen::Infinity>();
  }

  bool solve(const VectorXd& s, VectorXd& motion, double& value) {
    NewtonOptions rules;
    rules.tolerance = options_.tolerance;
    rules.max_iterations = options_.newton_iterations;
    const SolveReport report = newton(*task_.cost, s, motion, rules, workspace_);
    value = report.value;
    return report.status == SolveStatus::converged;
  }

  const WeightedCost& task_;
  const VectorXd& scale_;
  const CertificateOptions& options_;
  HessianFactor factor_;
  NewtonWorkspace workspace_;
  Evaluation at_, there_;
  TaskCertificate proof_;
};

VectorXd free_curvatures(const DesignIteration& iterate, const VectorXd& scale,
                         const std::vector<bool>& free) {
  if (iterate.reduced_hessian.size() == 0) return {};
  std::vector<int> index;
  for (int k = 0; k < scale.size(); ++k)
    if (free[k]) index.push_back(k);
  if (index.empty()) return {};
  const Eigen::MatrixXd scaled = scale.asDiagonal() * iterate.reduced_hessian * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled(index, index),
                                                        Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace

double Certificate::worst_gradient_error() const {
  double worst = 0.0;
  for (const TaskCertificate& task : tasks) {
    if (task.adjoint.size() == 0 || !task.error.allFinite())
      return std::numeric_limits<double>::infinity();
    if (task.error.size() > 0)
      worst = std::max(worst, task.error.maxCoeff() / std::max(task.largest, kLeastLargest));
  }
  return worst;
}

Certificate certify(const std::vector<WeightedCost>& tasks, const DesignSpace& space,
                    const DesignIteration& iterate, const CertificateOptions& options) {
  const VectorXd scale = space.scale(), lower = space.lower(), upper = space.upper();
  Certificate certificate;
  certificate.tasks.resize(tasks.size());
  parallel_for(static_cast<int>(tasks.size()), options.threads, [&](int i) {
    certificate.tasks[i] = TaskProof(tasks[i], scale, options).run(iterate.s, iterate.tasks[i]);
  });
  const VectorXd& gradient = iterate.design_gradient;
  const std::vector<bool> free = free_parameters(iterate.s, gradient, lower, upper);
  certificate.projected_gradient_norm =
      projected_gradient_norm(iterate.s, gradient, lower, upper, scale);
  certificate.curvatures = free_curvatures(iterate, scale, free);
  for (int k = 0; k < space.size(); ++k)
    if (!space.parameters[k].frozen() && (iterate.s[k] <= lower[k] || iterate.s[k] >= upper[k]))
      certificate.active.push_back({k, iterate.s[k] >= upper[k], gradient[k]});
  return certificate;
}

}  // namespace legwright
