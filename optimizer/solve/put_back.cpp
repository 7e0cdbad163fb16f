// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/put_back.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>

#include "optimizer/base/parallel.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr double kNoMotion = std::numeric_limits<double>::infinity();

/// One task at the result, and its motions of designs beside it.
class BesideResult {
 public:
  BesideResult(const WeightedCost& task, const DesignIteration& result, int index,
               const MotionLimits& limits)
      : task_(at_motion(task, result.tasks[index].m)),
        solver_(task_, limits, limits.checkpoint.in(index).in("result")),
        checkpoint_(limits.checkpoint.in(index)),
        s_(result.s) {
    ready_ = solver_.start(s_) && solver_.differentiate();
    base_ = value_at(s_, solver_.now().m);
    outer_ = solver_.now().outer_value;
  }

  void solve(PutBack& row) {
    const std::size_t k = row.decrease.size();
    row.decrease.push_back(kNoMotion);
    row.outer_decrease.push_back(0.0);
    row.terms.emplace_back();
    row.motions.emplace_back();
    solver_.set_checkpoint(checkpoint_.in(row.parameter));
    if (!ready_ || !std::isfinite(solver_.try_design(row.s, kNoMotion))) {
      row.motion_status = SolveStatus::not_finite;
      return;
    }
    solver_.accept();
    const TaskIterate& now = solver_.now();
    row.motions[k] = now.m;
    row.outer_decrease[k] = now.outer_value - outer_;
    if (now.motion_status != SolveStatus::converged) row.motion_status = now.motion_status;
    const Values there = value_at(row.s, now.m);
    row.decrease[k] = there.value - base_.value;
    for (std::size_t t = 0; t < base_.terms.size(); ++t)
      row.terms[k].push_back(there.terms[t] - base_.terms[t]);
    solver_.undo();
  }

 private:
  struct Values {
    double value = 0.0;
    std::vector<double> terms;
  };

  static WeightedCost at_motion(const WeightedCost& task, const VectorXd& m) {
    return {task.cost, task.weight, m, task.outer};
  }

  Values value_at(const VectorXd& s, const VectorXd& m) {
    task_.cost->evaluate(s, m, Order::value, at_);
    return {at_.value, at_.term_values};
  }

  WeightedCost task_;
  TaskSolver solver_;
  Checkpoint checkpoint_;
  VectorXd s_;
  Evaluation at_;
  bool ready_ = false;
  Values base_;
  double outer_ = 0.0;
};

std::vector<PutBack> changed_rows(const VectorXd& old_values, const VectorXd& s) {
  std::vector<PutBack> rows;
  for (int k = 0; k < s.size(); ++k) {
    if (s[k] == old_values[k]) continue;
    PutBack row;
    row.parameter = k;
    row.s = s;
    row.s[k] = old_values[k];
    row.motion_status = SolveStatus::converged;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

double PutBack::total(const std::vector<WeightedCost>& tasks) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < tasks.size(); ++i)
    sum += tasks[i].weight * (decrease[i] + outer_decrease[i]);
  return sum;
}

// Rows are compared with each other, some of them small: their motions are solved as the result's.
MotionLimits PutBackOptions::put_back_limits() {
  MotionLimits limits;
  limits.motion_tolerance = limits.final_tolerance;
  limits.trial_iterations = limits.motion_iterations;
  return limits;
}

std::vector<PutBack> put_back(const std::vector<std::vector<WeightedCost>>& threads,
                              const VectorXd& old_values, const DesignIteration& result,
                              const PutBackOptions& options) {
  std::vector<PutBack> rows = changed_rows(old_values, result.s);
  const int count = static_cast<int>(rows.size());
  const int workers = std::min(count, static_cast<int>(threads.size()));
  std::atomic<int> next = 0;
  std::vector<char> done(rows.size(), 0);
  parallel_for(workers, workers, [&](int worker) {
    std::vector<std::unique_ptr<BesideResult>> tasks;
    for (std::size_t i = 0; i < threads[worker].size(); ++i)
      tasks.push_back(std::make_unique<BesideResult>(threads[worker][i], result,
                                                     static_cast<int>(i), options.limits));
    for (int k = next++; k < count && !(options.stop && options.stop()); k = next++) {
      for (const auto& task : tasks) task->solve(rows[k]);
      done[k] = rows[k].motion_status != SolveStatus::stopped ? 1 : 0;
    }
  });
  std::size_t kept = 0;  // those before the first that was left out
  while (kept < rows.size() && done[kept] != 0) ++kept;
  rows.resize(kept);
  return rows;
}

}  // namespace legwright
