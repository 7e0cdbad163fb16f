// SPDX-License-Identifier: Apache-2.0
#include "tools/validate/physics_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimizer/base/parallel.hpp"

namespace legwright {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kSweeps = 200;     // of the box-constrained least squares; few unknowns
constexpr double kRidge = 1e-3;  // keeps scalars that change nothing where they are
constexpr double kTrustworthy = 0.75, kPoor = 0.25;  // actual over predicted decrease
constexpr double kMerit = 0.5;

/// argmin ½‖r + J d‖² + ½ ε‖d‖² in a box, by coordinate descent: exact for so small a convex
/// problem.
VectorXd step_in_box(const MatrixXd& jacobian, const VectorXd& residual, const VectorXd& low,
                     const VectorXd& high) {
  MatrixXd hessian = jacobian.transpose() * jacobian;
  hessian.diagonal().array() += kRidge;
  const VectorXd gradient = jacobian.transpose() * residual;
  VectorXd step = VectorXd::Zero(gradient.size());
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (Index i = 0; i < step.size(); ++i) {
      const double slope = gradient[i] + hessian.row(i).dot(step);
      step[i] = std::clamp(step[i] - slope / hessian(i, i), low[i], high[i]);
    }
  return step;
}

class Search {
 public:
  Search(const std::function<PhysicsTrial(const VectorXd&)>& play, const VectorXd& lower,
         const VectorXd& upper, const PhysicsStepOptions& options)
      : play_(play), lower_(lower), upper_(upper), options_(options), radius_(options.radius) {}

  PhysicsStepsResult run(const VectorXd& start) {
    out_.x = start;
    out_.start = out_.best = play_(start);
    out_.trials = 1;
    if (!std::isfinite(out_.start.merit())) return std::move(out_);
    for (int k = 0; k < options_.steps && !(options_.stop && options_.stop()); ++k) {
      if (jacobian_.size() == 0) differentiate();
      if (!step()) break;
    }
    return std::move(out_);
  }

 private:
  /// Forward differences, backward at an upper bound. A probe that cannot be played says nothing
  /// of its scalar.
  void differentiate() {
    const Index count = out_.x.size();
    std::vector<PhysicsTrial> probes(static_cast<std::size_t>(count));
    const VectorXd offset = VectorXd::NullaryExpr(count, [&](Index i) {
      return out_.x[i] + options_.probe <= upper_[i] ? options_.probe : -options_.probe;
    });
    parallel_for(static_cast<int>(count), options_.threads, [&](int i) {
      VectorXd x = out_.x;
      x[i] += offset[i];
      if (x[i] >= lower_[i]) probes[static_cast<std::size_t>(i)] = play_(x);
    });
    out_.trials += static_cast<int>(count);
    jacobian_ = MatrixXd::Zero(out_.best.residual.size(), count);
    for (Index i = 0; i < count; ++i) {
      const VectorXd& residual = probes[static_cast<std::size_t>(i)].residual;
      if (residual.size() == out_.best.residual.size() && residual.allFinite())
        jacobian_.col(i) = (residual - out_.best.residual) / offset[i];
    }
    fresh_ = true;
  }

  /// False when nothing is left to gain.
  bool step() {
    const VectorXd& residual = out_.best.residual;
    const VectorXd low = (lower_ - out_.x).cwiseMax(-radius_),
                   high = (upper_ - out_.x).cwiseMin(radius_);
    const VectorXd d = step_in_box(jacobian_, residual, low, high);
    const double before = out_.best.merit();
    PhysicsStep step{
        out_.x + d, radius_, kMerit * (residual + jacobian_ * d).squaredNorm(), {}, false};
    const double promised = before - step.predicted_merit;
    if (!(promised > options_.gain * before)) return refresh_or_end();
    step.trial = play_(step.x);
    ++out_.trials;
    const double gained = before - step.trial.merit();
    const bool keeps_verdict = step.trial.pass || !out_.best.pass;
    step.accepted = gained > options_.gain * before && keeps_verdict;
    const bool usable =
        step.trial.residual.size() == residual.size() && step.trial.residual.allFinite();
    if (usable) {  // Broyden: the model agrees with what was just seen
      jacobian_ +=
          (step.trial.residual - residual - jacobian_ * d) * d.transpose() / d.squaredNorm();
    }
    if (gained > kTrustworthy * promised) radius_ = std::min(2.0 * radius_, options_.largest);
    if (!step.accepted || gained < kPoor * promised) radius_ *= 0.5;
    if (step.accepted) {
      out_.x = step.x;
      out_.best = step.trial;
      fresh_ = false;
    } else if (!fresh_) {
      jacobian_.resize(0, 0);  // look again before going on
    }
    out_.steps.push_back(step);
    if (options_.on_step) options_.on_step(out_.steps.back());
    return radius_ >= options_.smallest;
  }

  bool refresh_or_end() {
    if (fresh_) return false;
    jacobian_.resize(0, 0);
    return true;
  }

  const std::function<PhysicsTrial(const VectorXd&)>& play_;
  const VectorXd lower_, upper_;
  const PhysicsStepOptions& options_;
  double radius_;
  MatrixXd jacobian_;   // ∂r/∂x; empty: to be found anew
  bool fresh_ = false;  // by differences at out_.x, not only updated
  PhysicsStepsResult out_;
};

}  // namespace

double PhysicsTrial::merit() const {
  if (residual.size() == 0 || !residual.allFinite()) return std::numeric_limits<double>::infinity();
  return kMerit * residual.squaredNorm();
}

PhysicsStepsResult take_physics_steps(const std::function<PhysicsTrial(const VectorXd&)>& play,
                                      const VectorXd& start, const VectorXd& lower,
                                      const VectorXd& upper, const PhysicsStepOptions& options) {
  return Search(play, lower, upper, options).run(start);
}

}  // namespace legwright
