// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/first_motion.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "optimizer/solve/task_solver.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr double kBetter = 0.99;    // F over that of the guess, below which a start counts
constexpr double kSpread = 0.15;    // amplitude of random joint motions [rad]
constexpr double kHalfSpeed = 0.5;  // of the plan that continuation starts from
constexpr double kScoutTolerance = 1e-3;
constexpr int kScoutIterations = 100;  // to compare starts; the winner is solved in full afterwards

struct ScoutedMotion {
  VectorXd m;
  double value = std::numeric_limits<double>::infinity();
};

/// The plan that Newton's method comes to from a start.
ScoutedMotion scout(const Objective& objective, const VectorXd& s, const VectorXd& start,
                    const FirstMotionOptions& options, const std::string& name) {
  ObjectiveCost cost(objective);
  WeightedCost task;
  task.cost = &cost;
  task.initial_motion = start;
  MotionLimits limits;
  limits.final_tolerance = kScoutTolerance;
  limits.motion_iterations = kScoutIterations;
  limits.newton.go_on = options.go_on;
  TaskSolver solver(task, limits, options.checkpoint.in(name));
  if (!solver.start(s)) return {};
  return {solver.now().m, solver.now().value};
}

/// The same robot and task, but for the speed.
Objective at_speed(const Objective& objective, double factor) {
  Task task = objective.task();
  task.velocity *= factor;
  task.turn_rate *= factor;
  return Objective(objective.morphology(), objective.space(), task);
}

/// The guess with a sine of the cycle on top of each joint's motion, of random amplitude and phase.
VectorXd perturbed(const Objective& objective, VectorXd m, std::mt19937_64& random) {
  const Layout& layout = objective.layout();
  const int joints = layout.pose_size() - 6, n = layout.design_size();
  std::uniform_real_distribution<double> amplitude(-kSpread, kSpread),
      phase(0.0, 2.0 * std::numbers::pi);
  for (int joint = 0; joint < joints; ++joint) {
    const double size = amplitude(random), offset = phase(random);
    for (int i = 0; i <= layout.knot_count(); ++i)
      m[layout.pose(i) - n + 6 + joint] +=
          size * std::sin(offset + 2.0 * std::numbers::pi * i / layout.knot_count());
  }
  return m;
}

}  // namespace

VectorXd best_first_motion(const Objective& objective, const VectorXd& s,
                           const FirstMotionOptions& options) {
  const VectorXd guess = initial_guess(objective, s);
  std::vector<std::pair<std::string, VectorXd>> starts;
  starts.emplace_back("first guess", guess);
  const Task& task = objective.task();
  if (task.velocity.norm() > 0.0 || task.turn_rate != 0.0) {
    starts.emplace_back("guess on the spot", initial_guess(at_speed(objective, 0.0), s));
    const Objective slower = at_speed(objective, kHalfSpeed);
    const ScoutedMotion plan =
        scout(slower, s, initial_guess(slower, s), options, "half the speed");
    if (std::isfinite(plan.value)) starts.emplace_back("plan of half the speed", plan.m);
  }
  std::mt19937_64 random(options.seed);
  for (int k = 0; k < options.perturbations; ++k)
    starts.emplace_back("perturbed guess " + std::to_string(k + 1),
                        perturbed(objective, guess, random));

  double least = std::numeric_limits<double>::infinity();
  const VectorXd* best = &guess;
  for (const auto& [name, start] : starts) {
    const double value = scout(objective, s, start, options, name).value;
    if (options.go_on && !options.go_on()) break;
    if (options.tell) options.tell(name, value);
    const bool first = &start == &starts.front().second;
    if (!(value < least) && !first) continue;
    least = first ? kBetter * value : value;
    best = &start;
  }
  return *best;
}

}  // namespace legwright
