// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/multistart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
    options.checkpoint = options.checkpoint.in(runs_++);
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
  int runs_ = 0;
  MultistartResult result_;
};

/// The trade-off between two tasks, point by point.
class Front {
 public:
  Front(const std::vector<JointTask>& tasks, const DesignSpace& space,
        const CodesignOptions& options)
      : tasks_(tasks), space_(space), options_(options) {
    options_.near_optimum = true;
  }

  /// Weights evenly spaced, and that of the joint run among them.
  void set_weights(int points) {
    std::vector<double> weights;
    for (int k = 0; k <= points + 1; ++k) weights.push_back(static_cast<double>(k) / (points + 1));
    const double joint = tasks_[0].weight / (tasks_[0].weight + tasks_[1].weight);
    const auto near = [&](double weight) { return std::abs(weight - joint) < kSameWeight; };
    if (std::none_of(weights.begin(), weights.end(), near)) weights.push_back(joint);
    std::sort(weights.begin(), weights.end());
    points_.resize(weights.size());
    for (std::size_t k = 0; k < weights.size(); ++k) points_[k].weight = weights[k];
  }

  /// The optimum of one task alone is an end; the motion of the other is solved at its design.
  void set_end(int own, const DesignIteration& best) {
    std::vector<VectorXd> motions(2);
    motions[own] = best.tasks.at(0).m;
    motions[1 - own] = tasks_[1 - own].guess(best.s);
    CodesignOptions still = options_;
    still.motion_only = true;
    FrontPoint& point = own == 0 ? points_.back() : points_.front();
    point = solve(point.weight, best.s, motions, still);
  }

  /// A design of all tasks that is known from elsewhere.
  void add_known(const StartedRun& run) {
    const DesignIteration& best = run.result.best;
    if (best.tasks.size() == 2 && std::isfinite(best.value))
      known_.push_back({0.0, best, run.result.status});
  }

  /// Each inner point from its neighbour's design.
  void walk(bool rising) {
    const std::size_t last = points_.size() - 1;
    for (std::size_t i = 1; i < last; ++i) {
      const std::size_t k = rising ? i : last - i;
      improve(points_[k], points_[rising ? k - 1 : k + 1]);
    }
  }

  /// Solves points anew from better designs that are known, until there are none.
  void settle() {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      bool changed = false;
      for (FrontPoint& point : points_) {
        const FrontPoint* start = &point;
        for (const auto* designs : {&known_, &points_})
          for (const FrontPoint& other : *designs)
            if (lower(value_of(other, point.weight), value_of(*start, point.weight)))
              start = &other;
        if (start == &point) continue;
        changed = true;
        const bool end = point.weight == 0.0 || point.weight == 1.0;
        if (end) {
          point = {point.weight, start->best, start->status};
          point.best.value = value_of(*start, point.weight);
        } else {
          improve(point, FrontPoint(*start));
        }
      }
      if (!changed) return;
    }
    adopt();
  }

  std::vector<FrontPoint> take() { return std::move(points_); }

 private:
  /// Each point as it is known best, nothing solved any more.
  void adopt() {
    std::vector<FrontPoint> all = points_;
    all.insert(all.end(), known_.begin(), known_.end());
    for (FrontPoint& point : points_)
      for (const FrontPoint& other : all) {
        const double value = value_of(other, point.weight);
        if (!lower(value, value_of(point, point.weight))) continue;
        point = {point.weight, other.best, other.status};
        point.best.value = value;
      }
  }

  static constexpr double kSameWeight = 1e-9;
  static constexpr int kSweeps = 4;

  static bool lower(double a, double b) { return a < b - 1e-9 * std::abs(b); }

  /// Σ w (F + J) of a design at another weight.
  static double value_of(const FrontPoint& point, double weight) {
    const std::vector<TaskIterate>& tasks = point.best.tasks;
    if (tasks.size() != 2) return std::numeric_limits<double>::infinity();
    const auto total = [&](int k) { return tasks[k].value + tasks[k].outer_value; };
    if (weight == 1.0) return total(0);
    if (weight == 0.0) return total(1);
    return weight * total(0) + (1.0 - weight) * total(1);
  }

  /// A point from another one's design and motions; kept where that is lower, as that design
  /// itself is.
  void improve(FrontPoint& point, const FrontPoint& from) {
    const DesignIteration& start = from.best;
    FrontPoint found = solve(point.weight, start.s, {start.tasks[0].m, start.tasks[1].m}, options_);
    if (!(found.best.value <= value_of(from, point.weight))) {  // stopped, or not finite
      found = {point.weight, start, from.status};
      found.best.value = value_of(from, point.weight);
    }
    if (point.best.tasks.empty() || found.best.value < point.best.value) point = std::move(found);
  }

  FrontPoint solve(double weight, const VectorXd& s, const std::vector<VectorXd>& motions,
                   CodesignOptions options) {
    options.checkpoint = options.checkpoint.in(solves_++);
    const CodesignResult result = codesign(
        {weighted(tasks_[0], weight, motions[0]), weighted(tasks_[1], 1.0 - weight, motions[1])},
        space_, s, options);
    return {weight, result.best, result.status};
  }

  const std::vector<JointTask>& tasks_;
  const DesignSpace& space_;
  CodesignOptions options_;
  int solves_ = 0;
  std::vector<FrontPoint> points_, known_;
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
                                        const DesignSpace& space, const MultistartResult& found,
                                        int points, const CodesignOptions& options) {
  if (tasks.size() != 2 || found.alone.size() != 2)
    throw std::invalid_argument("a trade-off front needs two tasks, each solved alone");
  Front front(tasks, space, options);
  front.set_weights(points);
  for (const int own : {0, 1})  // weight 1: the first task alone, at the far end
    front.set_end(own, found.alone[own].result.best);
  for (const StartedRun& run : found.joint) front.add_known(run);
  front.walk(true);
  front.walk(false);
  front.settle();
  return front.take();
}

}  // namespace legwright
