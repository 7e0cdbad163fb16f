// SPDX-License-Identifier: Apache-2.0
// How times grow with knots, legs, design parameters and tasks.
#include <cmath>
#include <memory>

#include "benchmarks/figures.hpp"
#include "benchmarks/made_up_robots.hpp"
#include "benchmarks/newton_parts.hpp"
#include "optimizer/motion/initial_guess.hpp"
#include "optimizer/solve/joint_newton.hpp"
#include "tools/task/task_file.hpp"

namespace legwright::bench {
namespace {

using Eigen::VectorXd;

constexpr double kGoalExponent = 1.1;
constexpr int kRounds = 5;
constexpr double kSeconds = 0.3;  // of each point, at least
constexpr int kSteps = 6;         // of body and motions together

Json to_json(const Curve& curve) {
  return {{"what", curve.what}, {"against", curve.against}, {"where", curve.where},
          {"x", curve.x},       {"seconds", curve.seconds}, {"exponent", curve.exponent()}};
}

Group of(std::vector<Curve> curves) {
  Group group;
  for (const Curve& curve : curves) {
    group.details["curves"].push_back(to_json(curve));
    group.figures.push_back({curve.what + " against " + curve.against + ", fitted exponent",
                             kGoalExponent, curve.exponent(), false, "", curve.where});
  }
  group.curves = std::move(curves);
  return group;
}

/// Seconds of the parts of Newton's method where the motion has settled.
std::vector<Times> times_of(const Objective& objective, const VectorXd& s) {
  VectorXd m = initial_guess(objective, s);
  (void)newton(objective, s, m);
  NewtonParts parts(objective, s, m);
  std::vector<Contestant> all = contestants(parts);
  all.pop_back();  // whole solves differ in their iterations
  return interleave(all, kRounds, kSeconds);
}

/// Seconds of a step of body and motions together, from the first guess.
double joint_step(const std::vector<WeightedCost>& tasks, const DesignSpace& space,
                  const VectorXd& s) {
  std::vector<VectorXd> motions;
  for (const WeightedCost& task : tasks) motions.push_back(task.initial_motion);
  JointNewtonOptions options;
  options.max_iterations = kSteps;
  int steps = 0;
  const DesignBox box{space.lower(), space.upper(), space.scale()};
  const auto run = [&] { steps = joint_newton(tasks, box, s, {motions}, options).iterations; };
  const double all = interleave({{"steps", run}}, kRounds, kSeconds)[0].min();
  return 1e-6 * all / std::max(1, steps);
}

}  // namespace

double Curve::exponent() const {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double a = std::log(x[k]), b = std::log(seconds[k]);
    sx += a, sy += b, sxx += a * a, sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

Group knots_figures(const SolvedCase& solved) {
  Curve iteration{
      "one Newton iteration",
      "knots",
      solved.of.label,
      {},
      {},
      "beyond some 48 knots F's derivatives do not fit a second-level cache of 1 MiB; up "
      "to there it is linear"};
  TaskFile file = solved.problem.task(0);
  file.planted_margin = file.period / 24;
  for (int count = 12; count <= 384; count *= 2) {
    file.knots = count;
    const Objective objective(solved.problem.robot.morphology, solved.problem.robot.space,
                              make_task(file, solved.problem.robot));
    iteration.x.push_back(count);
    iteration.seconds.push_back(1e-6 * times_of(objective, solved.s)[kIteration].min());
  }
  return of({iteration});
}

Group legs_figures(const SolvedCase& solved) {
  Curve iteration{"one Newton iteration",
                  "legs",
                  solved.of.label,
                  {},
                  {},
                  "H has an entry for each pair of joints, and each pair of limbs is kept apart"};
  Curve floor{"factor + solve",
              "legs",
              solved.of.label,
              {},
              {},
              "the blocks of a knot grow, and their products with the third power"};
  const Morphology body = frozen(solved.problem.robot.morphology, solved.s);
  for (int rows = 1; rows <= 6; ++rows) {
    const Morphology robot = with_rows(body, rows);
    const Objective objective(robot, {}, alternating(solved.problem.objectives[0]->task(), robot));
    const std::vector<Times> times = times_of(objective, {});
    iteration.x.push_back(2 * rows);
    iteration.seconds.push_back(1e-6 * times[kIteration].min());
    floor.x.push_back(2 * rows);
    floor.seconds.push_back(1e-6 * times[kFloor].min());
  }
  return of({iteration, floor});
}

Group parameters_figures(const SolvedCase& solved) {
  Curve step{"a step of body and motion together",
             "design parameters",
             solved.of.label,
             {},
             {},
             "the Schur complement BᵀH⁻¹B has an entry for each pair"};
  const Morphology body = frozen(solved.problem.robot.morphology, solved.s);
  for (const int count : {5, 10, 20, 50, 100, 200}) {
    Morphology robot = body;
    const DesignSpace space = give_parameters(robot, count);
    const Objective objective(robot, space, solved.problem.objectives[0]->task());
    ObjectiveCost cost(objective);
    const VectorXd s = space.initial();
    step.x.push_back(count);
    step.seconds.push_back(joint_step({{&cost, 1.0, initial_guess(objective, s)}}, space, s));
  }
  return of({step});
}

Group tasks_figures(const SolvedCase& solved) {
  Curve step{"a step of body and motions together", "tasks", solved.of.label, {}, {}, ""};
  const Objective& objective = *solved.problem.objectives[0];
  const DesignSpace& space = solved.problem.robot.space;
  const VectorXd s = space.initial();
  std::vector<std::unique_ptr<ObjectiveCost>> costs;
  std::vector<WeightedCost> tasks;
  for (int count = 1; count <= 8; count *= 2) {
    while (static_cast<int>(tasks.size()) < count) {
      costs.push_back(std::make_unique<ObjectiveCost>(objective));
      tasks.push_back({costs.back().get(), 1.0, initial_guess(objective, s)});
    }
    step.x.push_back(count);
    step.seconds.push_back(joint_step(tasks, space, s));
  }
  return of({step});
}

}  // namespace legwright::bench
