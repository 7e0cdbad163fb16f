// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/newton_parts.hpp"

#include <stdexcept>

#include "optimizer/motion/initial_guess.hpp"

namespace legwright::bench {
namespace {

using Eigen::VectorXd;

void require(bool success) {
  if (!success) throw std::runtime_error("a factorisation or solution failed");
}

}  // namespace

NewtonParts::NewtonParts(const Objective& objective, const VectorXd& s, const VectorXd& m)
    : objective_(objective), cost_(objective), s_(s), m_(m) {
  cost_.evaluate(s_, m_, Order::hessian, at_);
  require(factor_.factor(at_.hessian_mm, {}));
}

void NewtonParts::factor_and_solve() {
  require(factor_.factor(at_.hessian_mm, {}) && factor_.solve(at_.stationarity, step_));
}

void NewtonParts::iteration() {
  evaluate(Order::hessian);
  factor_and_solve();
  evaluate(Order::gradient);
}

void NewtonParts::solve_from_standing() {
  VectorXd from = initial_guess(objective_, s_);
  report_ = newton(cost_, s_, from, {}, workspace_);
}

std::vector<Contestant> contestants(NewtonParts& parts) {
  return {{"factor + solve", [&] { parts.factor_and_solve(); }},
          {"F + gradient", [&] { parts.evaluate(Order::gradient); }},
          {"F + gradient + Hessian", [&] { parts.evaluate(Order::hessian); }},
          {"Newton iteration", [&] { parts.iteration(); }},
          {"motion solve from standing", [&] { parts.solve_from_standing(); }}};
}

}  // namespace legwright::bench
