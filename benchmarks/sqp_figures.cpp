// SPDX-License-Identifier: Apache-2.0
// The same motion by sequential quadratic programming: Kraft's SLSQP as NLopt has it, on the same F
// and gradient, from the same start. It keeps a dense BFGS model of the Hessian.
#include <fmt/format.h>

#include <cmath>
#include <nlopt.hpp>
#include <vector>

#include "benchmarks/figures.hpp"
#include "benchmarks/timing.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "optimizer/solve/newton.hpp"

namespace legwright::bench {
namespace {

using Eigen::Map;
using Eigen::VectorXd;

constexpr double kMostSeconds = 20.0;
constexpr double kSame = 1e-3;  // F this near to ours counts as reached

/// F(s, ·) in the variables m/unit, as SLSQP asks for it.
struct MotionFunction {
  CostFunction& cost;
  const VectorXd& s;
  VectorXd units = cost.motion_units();
  Evaluation at = {};

  static double value(unsigned n, const double* x, double* gradient, void* self) {
    auto& here = *static_cast<MotionFunction*>(self);
    const VectorXd m = Map<const VectorXd>(x, n).cwiseProduct(here.units);
    here.cost.evaluate(here.s, m, gradient ? Order::gradient : Order::value, here.at);
    if (gradient) Map<VectorXd>(gradient, n) = here.at.stationarity.cwiseProduct(here.units);
    return here.at.value;
  }
};

struct Found {
  double value = NAN, seconds = 0.0;
  int evaluations = 0;
};

Found by_slsqp(CostFunction& cost, const VectorXd& s, const VectorXd& start, double goal) {
  MotionFunction function{cost, s};
  nlopt::opt solver(nlopt::LD_SLSQP, static_cast<unsigned>(start.size()));
  solver.set_min_objective(MotionFunction::value, &function);
  solver.set_maxtime(kMostSeconds);
  solver.set_stopval(goal);
  const VectorXd scaled = start.cwiseQuotient(function.units);
  std::vector<double> x(scaled.data(), scaled.data() + scaled.size());
  Found found;
  const double before = thread_microseconds();
  try {
    (void)solver.optimize(x, found.value);
  } catch (const std::exception&) {  // it got no further; the value is the best so far
  }
  found.seconds = 1e-6 * (thread_microseconds() - before);
  found.evaluations = solver.get_numevals();
  return found;
}

}  // namespace

Group sqp_figures(const SolvedCase& solved) {
  Group group;
  for (int k = 0; k < solved.problem.task_count(); ++k) {
    const Objective& objective = *solved.problem.objectives[k];
    ObjectiveCost cost(objective);
    const VectorXd start = initial_guess(objective, solved.s);
    NewtonWorkspace workspace;
    VectorXd m = start;
    const double before = thread_microseconds();
    const SolveReport ours = newton(cost, solved.s, m, {}, workspace);
    const double seconds = 1e-6 * (thread_microseconds() - before);
    const Found theirs = by_slsqp(cost, solved.s, start, ours.value * (1.0 + kSame));
    const std::string& name = solved.problem.task(k).name;
    group.details[name] = {{"newton_seconds", seconds},
                           {"newton_F", ours.value},
                           {"slsqp_seconds", theirs.seconds},
                           {"slsqp_F", theirs.value},
                           {"slsqp_evaluations", theirs.evaluations}};
    const std::string where = solved.of.label + ": " + name;
    if (theirs.value <= ours.value * (1.0 + kSame))
      group.figures.push_back({"SLSQP (NLopt) over our inner solve, to 0.1 % of its F", 10,
                               theirs.seconds / seconds, true, "×", where});
    else
      group.notes.push_back(fmt::format(
          "{}: SLSQP (NLopt) has F {:.4g} after {:.0f} s and {} evaluations, where our "
          "inner solve has {:.4g} after {:.2g} s",
          where, theirs.value, theirs.seconds, theirs.evaluations, ours.value, seconds));
  }
  return group;
}

}  // namespace legwright::bench
