// SPDX-License-Identifier: Apache-2.0
// What one Newton iteration costs, measured by the factorisation it cannot do without.
#include <algorithm>

#include "benchmarks/figures.hpp"
#include "benchmarks/newton_parts.hpp"

namespace legwright::bench {

Group iteration_figures(const SolvedCase& solved) {
  Group group;
  double iteration = 0.0, gradient = 0.0, hessian = 0.0;
  for (int k = 0; k < solved.problem.task_count(); ++k) {
    NewtonParts parts(*solved.problem.objectives[k], solved.s, solved.m[k]);
    const std::vector<Times> times = interleave(contestants(parts));
    const auto over_floor = [&](NewtonContestant each) {
      return times[each].min() / times[kFloor].min();
    };
    const int iterations = parts.report().iterations;
    Json& details = group.details[solved.problem.task(k).name];
    details["unknowns"] = solved.m[k].size();
    details["times"] = to_json(times);
    details["iteration_over_floor"] = over_floor(kIteration);
    details["gradient_over_floor"] = over_floor(kGradient);
    details["hessian_over_floor"] = over_floor(kHessian);
    details["solve_iterations"] = iterations;
    details["solve_iteration_over_floor"] = over_floor(kSolve) / std::max(1, iterations);
    iteration = std::max(iteration, over_floor(kIteration));
    gradient = std::max(gradient, over_floor(kGradient));
    hessian = std::max(hessian, over_floor(kHessian));
  }
  const std::string& where = solved.of.label;
  group.figures = {
      {"one Newton iteration over factor + solve of the same H", 1.5, iteration, false, "×", where},
      {"F + gradient over factor + solve", 0.15, gradient, false, "×", where},
      {"F + gradient + exact Hessian over factor + solve", 0.5, hessian, false, "×", where}};
  return group;
}

}  // namespace legwright::bench
