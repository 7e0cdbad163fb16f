// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/first_motion.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "optimizer/base/parallel.hpp"
#include "optimizer/motion/initial_guess.hpp"
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

Task at_speed(Task task, double factor) {
  task.velocity *= factor;
  task.turn_rate *= factor;
  return task;
}

/// The first guess of the same robot on the spot, for which no objective need be built.
VectorXd guess_on_the_spot(const Objective& objective, const VectorXd& s) {
  const Task task = at_speed(objective.task(), 0.0);
  const WantedPath path(task.velocity, task.turn_rate, task.gait.period());
  const VectorXd initial = objective.space().initial();
  const StyleTargets style = style_targets(objective.morphology(), initial, task);
  return initial_guess(objective.morphology(), objective.layout(), task, path,
                       at_design(style, s - initial), s);
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

/// A first motion that is tried, and the F that a solve comes to from it.
struct Start {
  std::string name;
  std::function<VectorXd()> make;
  VectorXd m = {};
  double value = std::numeric_limits<double>::infinity();
  bool tried = false;  // to the end
};

/// In the order in which they are compared.
std::vector<Start> starts_of(const Objective& objective, const VectorXd& s, const VectorXd& guess,
                             const FirstMotionOptions& options) {
  std::vector<Start> starts;
  starts.push_back({"first guess", [&guess] { return guess; }});
  const Task& task = objective.task();
  if (task.velocity.norm() > 0.0 || task.turn_rate != 0.0) {
    starts.push_back({"guess on the spot", [&] { return guess_on_the_spot(objective, s); }});
    starts.push_back({"plan of half the speed", [&] {
                        const Objective slower(objective.morphology(), objective.space(),
                                               at_speed(objective.task(), kHalfSpeed));
                        if (options.stopped()) return VectorXd();
                        const ScoutedMotion plan =
                            scout(slower, s, initial_guess(slower, s), options, "half the speed");
                        return std::isfinite(plan.value) ? plan.m : VectorXd();
                      }});
  }
  std::mt19937_64 random(options.seed);
  for (int k = 0; k < options.perturbations; ++k) {
    VectorXd m = perturbed(objective, guess, random);
    starts.push_back(
        {"perturbed guess " + std::to_string(k + 1), [m = std::move(m)] { return m; }});
  }
  return starts;
}

}  // namespace

VectorXd best_first_motion(const Objective& objective, const VectorXd& s,
                           const FirstMotionOptions& options) {
  const VectorXd guess = initial_guess(objective, s);
  std::vector<Start> starts = starts_of(objective, s, guess, options);
  // From the last to the first: the plan of half the speed takes two solves.
  const int count = static_cast<int>(starts.size());
  parallel_for(count, options.threads, [&](int k) {
    Start& start = starts[static_cast<std::size_t>(count - 1 - k)];
    if (options.stopped()) return;
    start.m = start.make();
    if (start.m.size() == 0 || options.stopped()) return;
    start.value = scout(objective, s, start.m, options, start.name).value;
    start.tried = !options.stopped();
  });
  double least = std::numeric_limits<double>::infinity();
  const VectorXd* best = &guess;
  for (const Start& start : starts) {
    if (!start.tried) continue;
    if (options.tell) options.tell(start.name, start.value);
    const bool first = &start == &starts.front();
    if (!(start.value < least) && !first) continue;
    least = first ? kBetter * start.value : start.value;
    best = &start.m;
  }
  return *best;
}

}  // namespace legwright
