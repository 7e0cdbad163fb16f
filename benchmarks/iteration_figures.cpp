// SPDX-License-Identifier: Apache-2.0
// What one Newton iteration costs, measured by the factorisation it cannot do without.
#include <cmath>
#include <stdexcept>

#include "benchmarks/figures.hpp"
#include "benchmarks/timing.hpp"
#include "tools/task/task_file.hpp"

namespace legwright::bench {
namespace {

using Eigen::VectorXd;

void require(bool success) {
  if (!success) throw std::runtime_error("a factorisation or solution failed");
}

/// Everything that is timed at one point (s, m*) of one task.
struct Parts {
  Parts(const Objective& o, const VectorXd& design, const VectorXd& motion)
      : objective(o), cost(o), s(design), m(motion) {
    cost.evaluate(s, m, Order::hessian, at);
    require(factor.factor(at.hessian_mm, {}));
  }
  void evaluate(Order order) { cost.evaluate(s, m, order, order == Order::hessian ? at : trial); }
  void factor_and_solve() {
    require(factor.factor(at.hessian_mm, {}) && factor.solve(at.stationarity, step));
  }
  // F, G and H, factor, solve, and F with G at the trial point.
  void bare_iteration() {
    evaluate(Order::hessian);
    factor_and_solve();
    evaluate(Order::gradient);
  }
  void whole_solve() {
    VectorXd from = initial_guess(objective, s);
    report = newton(cost, s, from, {}, workspace);
  }

  const Objective& objective;
  ObjectiveCost cost;
  const VectorXd& s;
  const VectorXd& m;
  Evaluation at, trial;
  HessianFactor factor;
  VectorXd step;
  NewtonWorkspace workspace;
  SolveReport report;
};

std::vector<Contestant> contestants(Parts& parts) {
  return {{"factor + solve", [&] { parts.factor_and_solve(); }},
          {"F + gradient", [&] { parts.evaluate(Order::gradient); }},
          {"F + gradient + Hessian", [&] { parts.evaluate(Order::hessian); }},
          {"Newton iteration", [&] { parts.bare_iteration(); }},
          {"motion solve from standing", [&] { parts.whole_solve(); }}};
}

/// Exponent of y against x by least squares on the logarithms.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double a = std::log(x[k]), b = std::log(y[k]);
    sx += a, sy += b, sxx += a * a, sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace

Group iteration_figures(const SolvedCase& solved) {
  Group group;
  double iteration = 0.0, evaluation = 0.0;
  for (int k = 0; k < solved.problem.task_count(); ++k) {
    Parts parts(*solved.problem.objectives[k], solved.s, solved.m[k]);
    const std::vector<Times> times = interleave(contestants(parts));
    const double floor = times[0].min();
    Json& details = group.details[solved.problem.task(k).name];
    details["unknowns"] = parts.m.size();
    details["times"] = to_json(times);
    details["iteration_over_floor"] = times[3].min() / floor;
    details["hessian_over_floor"] = times[2].min() / floor;
    details["solve_iterations"] = parts.report.iterations;
    details["solve_iteration_over_floor"] =
        times[4].min() / floor / std::max(1, parts.report.iterations);
    iteration = std::max(iteration, times[3].min() / floor);
    evaluation = std::max(evaluation, times[2].min() / floor);
  }
  group.figures = {{"one Newton iteration over factor + solve of the same H", 2.0, 1.5, iteration,
                    false, "×", solved.of.label},
                   {"F + gradient + exact Hessian over factor + solve", 0.5, 0.35, evaluation,
                    false, "×", solved.of.label}};
  return group;
}

Group knots_figures(const SolvedCase& solved) {
  Group group;
  TaskFile file = solved.problem.task(0);
  file.planted_margin = file.period / 24;
  std::vector<double> knots, iteration, solve;
  for (int count = 12; count <= 384; count *= 2) {
    file.knots = count;
    const Objective objective(solved.problem.robot.morphology, solved.problem.robot.space,
                              make_task(file, solved.problem.robot));
    VectorXd m = initial_guess(objective, solved.s);
    const SolveReport report = newton(objective, solved.s, m);
    Parts parts(objective, solved.s, m);
    const std::vector<Times> times = interleave(contestants(parts), 5, 0.3);
    knots.push_back(count);
    iteration.push_back(times[3].min());
    solve.push_back(times[4].min());
    group.details[std::to_string(count)] = {{"unknowns", m.size()},
                                            {"newton_iterations", report.iterations},
                                            {"status", std::string(to_string(report.status))},
                                            {"times", to_json(times)}};
  }
  const double exponent = fitted_exponent(knots, iteration);
  group.details["exponent_of_an_iteration"] = exponent;
  group.details["exponent_of_a_solve"] = fitted_exponent(knots, solve);
  group.figures = {{"one Newton iteration against knots T = 12 … 384, fitted exponent", 1.15, 1.05,
                    exponent, false, "", solved.of.label}};
  return group;
}

}  // namespace legwright::bench
