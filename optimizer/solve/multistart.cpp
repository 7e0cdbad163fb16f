// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/multistart.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>

namespace legwright {
namespace {

using Eigen::VectorXd;

class Multistart {
 public:
  Multistart(const std::vector<JointTask>& tasks, const DesignSpace& space,
             const MultistartOptions& options)
      : tasks_(tasks), space_(space), options_(options), all_(tasks.size()) {
    std::iota(all_.begin(), all_.end(), 0);
  }

  MultistartResult run() {
    const VectorXd initial = space_.initial();
    result_.joint.push_back(run_one({"initial", all_}, initial, {}));
    if (tasks_.size() > 1 && options_.from_single_tasks) start_from_single_tasks(initial);
    std::mt19937_64 random(options_.seed);
    for (int k = 0; k < options_.perturbations && !result_.stopped; ++k)
      result_.joint.push_back(
          run_one({"random-" + std::to_string(k + 1), all_}, perturbed(initial, random), {}));
    for (std::size_t k = 0; k < result_.joint.size(); ++k)
      if (better(result_.joint[k].result, result_.winner())) result_.best = static_cast<int>(k);
    return std::move(result_);
  }

 private:
  void start_from_single_tasks(const VectorXd& initial) {
    for (int i : all_) {
      if (result_.stopped) return;
      result_.alone.push_back(run_one({"initial", {i}}, initial, {}));
    }
    for (int i : all_) {
      if (result_.stopped) return;
      const DesignIteration& own = result_.alone[i].result.best;
      if (own.tasks.empty()) continue;
      std::vector<VectorXd> motions(tasks_.size());
      motions[i] = own.tasks[0].m;
      result_.joint.push_back(run_one({tasks_[i].name, all_}, own.s, motions));
    }
  }

  /// @param motions per task of the label; empty ones are guessed.
  StartedRun run_one(const RunLabel& label, const VectorXd& s, std::vector<VectorXd> motions) {
    motions.resize(tasks_.size());
    std::vector<WeightedCost> costs;
    for (int i : label.tasks) {
      if (motions[i].size() == 0) motions[i] = tasks_[i].guess(s);
      const double weight = label.tasks.size() == 1 ? 1.0 : tasks_[i].weight;
      costs.push_back(weighted(tasks_[i], weight, motions[i]));
    }
    CodesignOptions options = options_.codesign;
    options.on_iteration = [&](const DesignIteration& iteration) {
      const bool go_on = !options_.on_iteration || options_.on_iteration(label, iteration);
      result_.stopped = result_.stopped || !go_on;
      return go_on;
    };
    return {label, codesign(costs, space_, s, options)};
  }

  VectorXd perturbed(const VectorXd& initial, std::mt19937_64& random) const {
    VectorXd s = initial;
    const VectorXd scale = space_.scale();
    for (int k = 0; k < s.size(); ++k) {
      const double uniform = static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0;  // [−1, 1)
      s[k] += options_.spread * scale[k] * uniform;
    }
    return space_.clamp(s);
  }

  static bool better(const CodesignResult& a, const CodesignResult& b) {
    if (a.status == SolveStatus::not_finite) return false;
    return b.status == SolveStatus::not_finite || a.best.value < b.best.value;
  }

  const std::vector<JointTask>& tasks_;
  const DesignSpace& space_;
  const MultistartOptions& options_;
  std::vector<int> all_;
  MultistartResult result_;
};

/// A walk along the front from one end; leaves every point where it came lower than before.
class FrontWalk {
 public:
  FrontWalk(const std::vector<JointTask>& tasks, const DesignSpace& space,
            const CodesignOptions& options)
      : tasks_(tasks), space_(space), options_(options) {
    options_.near_optimum = true;
  }

  /// Both tasks' motions at a design that one of them chose.
  FrontPoint end(double weight, const VectorXd& s, int own, const VectorXd& own_motion) const {
    std::vector<VectorXd> motions(2);
    motions[own] = own_motion;
    motions[1 - own] = tasks_[1 - own].guess(s);
    CodesignOptions still = options_;
    still.motion_only = true;
    return solve(weight, s, motions, still);
  }

  void improve(std::vector<FrontPoint>& points, int from, int step) const {
    const int last = step > 0 ? static_cast<int>(points.size()) - 2 : 1;
    for (int k = from + step; step > 0 ? k <= last : k >= last; k += step) {
      const DesignIteration& start = points[k - step].best;
      const FrontPoint found =
          solve(points[k].weight, start.s, {start.tasks[0].m, start.tasks[1].m}, options_);
      if (points[k].best.tasks.empty() || found.best.value < points[k].best.value)
        points[k] = found;
    }
  }

 private:
  FrontPoint solve(double weight, const VectorXd& s, const std::vector<VectorXd>& motions,
                   const CodesignOptions& options) const {
    const CodesignResult result = codesign(
        {weighted(tasks_[0], weight, motions[0]), weighted(tasks_[1], 1.0 - weight, motions[1])},
        space_, s, options);
    return {weight, result.best, result.status};
  }

  const std::vector<JointTask>& tasks_;
  const DesignSpace& space_;
  CodesignOptions options_;
};

}  // namespace

WeightedCost weighted(const JointTask& task, double weight, const VectorXd& motion) {
  WeightedCost cost;
  cost.cost = task.cost;
  cost.outer = task.outer;
  cost.weight = weight;
  cost.initial_motion = motion;
  return cost;
}

MultistartResult codesign_from_starts(const std::vector<JointTask>& tasks, const DesignSpace& space,
                                      const MultistartOptions& options) {
  return Multistart(tasks, space, options).run();
}

std::vector<FrontPoint> trade_off_front(const std::vector<JointTask>& tasks,
                                        const DesignSpace& space,
                                        const std::vector<StartedRun>& alone, int points,
                                        const CodesignOptions& options) {
  if (tasks.size() != 2 || alone.size() != 2)
    throw std::invalid_argument("a trade-off front needs two tasks, each solved alone");
  const FrontWalk walk(tasks, space, options);
  std::vector<FrontPoint> front(points + 2);
  for (int k = 1; k <= points; ++k) front[k].weight = static_cast<double>(k) / (points + 1);
  for (const int own : {0, 1}) {  // weight 1: the first task alone, at the far end
    const DesignIteration& best = alone[own].result.best;
    (own == 0 ? front.back() : front.front()) =
        walk.end(own == 0 ? 1.0 : 0.0, best.s, own, best.tasks.at(0).m);
  }
  walk.improve(front, 0, +1);
  walk.improve(front, points + 1, -1);
  return front;
}

}  // namespace legwright
