// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "optimizer/solve/codesign.hpp"

namespace legwright {

/// One task of a joint run, and how to begin with it at any design.
struct JointTask {
  std::string name;
  CostFunction* cost = nullptr;                                    // Fᵢ; must live longer
  CostFunction* outer = nullptr;                                   // Jᵢ or null; must live longer
  double weight = 1.0;                                             // wᵢ
  std::function<Eigen::VectorXd(const Eigen::VectorXd& s)> guess;  // m₀ at a design
};

/// A task as codesign() and certify() take it. @param motion initial motion; may be empty for
/// certify()
[[nodiscard]] WeightedCost weighted(const JointTask& task, double weight,
                                    const Eigen::VectorXd& motion);

/// Which of several runs an iteration belongs to.
struct RunLabel {
  std::string
      start;  // "initial", "pace" (where the optimum of that task alone is the start), "random-1"
  std::vector<int> tasks;  // of the run, by index: one for a task alone, else all
};

struct MultistartOptions {
  CodesignOptions codesign;
  bool from_single_tasks = true;  // with several tasks: also start from the optimum of each alone
  int perturbations = 0;          // further starts: the initial design, moved at random
  double spread = 0.15;           // by up to this many natural units
  std::uint64_t seed = 1;
  /// As CodesignOptions::on_iteration (which is not used), with the run it belongs to.
  std::function<bool(const RunLabel&, const DesignIteration&)> on_iteration = {};
};

/// One co-design run from one design.
struct StartedRun {
  RunLabel label;
  CodesignResult result;
};

struct MultistartResult {
  std::vector<StartedRun>
      alone;  // each task by itself from the initial design; empty with one task
  std::vector<StartedRun> joint;  // all tasks, from each start
  int best = 0;                   // of `joint`: the least F_joint
  bool stopped = false;           // the caller asked to
  const CodesignResult& winner() const { return joint[best].result; }
};

/// Co-design from several starts, because F_joint has many local minima and the one next to the
/// initial design is seldom the best: from the initial design, from the optimum of each task alone,
/// and from seeded perturbations. Runs follow one another in a fixed order; same bits every time.
[[nodiscard]] MultistartResult codesign_from_starts(const std::vector<JointTask>& tasks,
                                                    const DesignSpace& space,
                                                    const MultistartOptions& options);

/// One point of the trade-off between two tasks.
struct FrontPoint {
  double weight = 0.0;  // of the first task; the second has 1 − weight
  DesignIteration best;
  SolveStatus status = SolveStatus::iteration_limit;
};

/// Walks the weight from one task to the other by continuation, in both directions, each point from
/// its neighbour's design and motions, and keeps the lower F_joint at each; then each point is
/// solved anew from any other design, of the joint runs too, that is better at its weight. So none
/// lies above another one, nor above a joint run. Ends are the optima of each task alone (motion of
/// the other task re-solved at that design), or a joint run that does that task better.
/// options.on_iteration is called for every point's iterations; once it says stop, each point keeps
/// what it has. @param found the tasks solved alone and together. @param points weights strictly
/// between 0 and 1 that are tried, evenly spaced; the joint run's own is added. Rising weight.
[[nodiscard]] std::vector<FrontPoint> trade_off_front(const std::vector<JointTask>& tasks,
                                                      const DesignSpace& space,
                                                      const MultistartResult& found, int points,
                                                      const CodesignOptions& options);

}  // namespace legwright
