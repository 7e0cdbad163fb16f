// SPDX-License-Identifier: Apache-2.0
// Price of a design parameter: the adjoint design gradient at 5 to 200 of them.
#include <cmath>
#include <stdexcept>

#include "benchmarks/figures.hpp"
#include "benchmarks/made_up_robots.hpp"
#include "benchmarks/timing.hpp"
#include "optimizer/solve/adjoint.hpp"

namespace legwright::bench {
namespace {

using Eigen::VectorXd;

/// dF/ds and a Newton iteration of one robot.
class Gradient {
 public:
  Gradient(const Objective& objective, const VectorXd& s, VectorXd m)
      : cost_(objective), s_(s), m_(std::move(m)) {
    report_ = newton(cost_, s_, m_, {}, workspace_);
    if (report_.status != SolveStatus::converged)
      throw std::runtime_error("the motion of the robot with made-up parameters did not converge");
    cost_.evaluate(s_, m_, Order::hessian, at_);
    if (!factor_.factor(at_.hessian_mm, {})) throw std::runtime_error("not a minimum");
  }
  // As in co-design: Newton's method leaves the exact factor behind.
  void by_adjoint() {
    cost_.evaluate(s_, m_, Order::design, design_);
    result_ = adjoint(factor_, design_.stationarity, design_.hessian_ms, design_.partial_s);
  }
  void newton_iteration() {
    cost_.evaluate(s_, m_, Order::hessian, at_);
    if (!factor_.factor(at_.hessian_mm, {}) || !factor_.solve(at_.stationarity, step_))
      throw std::runtime_error("not a minimum");
    cost_.evaluate(s_, m_, Order::gradient, trial_);
  }
  // One entry of dF/ds: two motion solves from m*.
  double by_differences(int k) {
    constexpr double h = 1e-5;
    double value[2];
    for (const int side : {0, 1}) {
      VectorXd s = s_, m = m_;
      s[k] += side == 1 ? h : -h;
      value[side] = newton(cost_, s, m, {}, workspace_).value;
    }
    return (value[1] - value[0]) / (2 * h);
  }
  double entry(int k) const { return result_.dJ_ds[k]; }

 private:
  ObjectiveCost cost_;
  VectorXd s_, m_, step_;
  Evaluation at_, trial_, design_;
  HessianFactor factor_;
  NewtonWorkspace workspace_;
  SolveReport report_;
  AdjointResult result_;
};

}  // namespace

Group gradient_figures(const SolvedCase& solved) {
  Group group;
  std::vector<double> counts, seconds;
  const Morphology body = frozen(solved.problem.robot.morphology, solved.s);
  for (const int count : {5, 10, 20, 50, 100, 200}) {
    Morphology robot = body;
    const DesignSpace space = give_parameters(robot, count);
    const Objective objective(robot, space, solved.problem.objectives[0]->task());
    Gradient gradient(objective, space.initial(), solved.m[0]);
    double worst = 0.0;
    int entry = 0;
    const std::vector<Times> times =
        interleave({{"Newton iteration", [&] { gradient.newton_iteration(); }},
                    {"design gradient by adjoint", [&] { gradient.by_adjoint(); }},
                    {"one entry by central differences", [&] {
                       const double difference = gradient.by_differences(entry);
                       const double error = std::abs(difference - gradient.entry(entry));
                       worst = std::max(worst, error / std::max(1.0, std::abs(difference)));
                       entry = (entry + 7) % count;
                     }}});
    const double adjoint = times[1].min();
    const double over_iteration = adjoint / times[0].min();
    const double faster = count * times[2].median() / times[1].median();
    counts.push_back(count);
    seconds.push_back(1e-6 * adjoint);
    group.details[std::to_string(count)] = {{"times", to_json(times)},
                                            {"over_newton_iteration", over_iteration},
                                            {"differences_over_adjoint", faster},
                                            {"largest_disagreement", worst}};
    if (count != 10 && count != 50 && count != 200) continue;
    const std::string at = "at " + std::to_string(count) + " parameters";
    group.figures.push_back({"design gradient over one Newton iteration, " + at, 1.0,
                             over_iteration, false, "×", solved.of.label});
    group.figures.push_back({"central differences over the adjoint gradient, " + at,
                             static_cast<double>(count), faster, true, "×", solved.of.label});
  }
  group.curves = {{"dF/ds by the adjoint, with ∂G/∂s", "design parameters", solved.of.label, counts,
                   seconds, "∂G/∂s has a column for each"}};
  return group;
}

}  // namespace legwright::bench
