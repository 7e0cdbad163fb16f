// SPDX-License-Identifier: Apache-2.0
#include "tools/session/weight_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr int kLatticeSweeps = 3;  // of points that are solved anew

/// All ways to share `steps` among so many tasks, the first with the most first.
void add_shares(std::vector<int>& shares, int left, std::size_t tasks,
                std::vector<std::vector<int>>& out) {
  if (shares.size() + 1 == tasks) {
    out.push_back(shares);
    out.back().push_back(left);
    return;
  }
  for (int share = left; share >= 0; --share) {
    shares.push_back(share);
    add_shares(shares, left - share, tasks, out);
    shares.pop_back();
  }
}

class LatticeFront {
 public:
  LatticeFront(const std::vector<JointTask>& tasks, const DesignSpace& space, int steps,
               CodesignOptions options)
      : tasks_(tasks), space_(space), options_(std::move(options)) {
    options_.near_optimum = true;
    std::vector<std::vector<int>> all;
    std::vector<int> shares;
    add_shares(shares, steps, tasks.size(), all);
    for (const std::vector<int>& one : all) {
      LatticePoint& point = points_.emplace_back();
      for (const int share : one) point.weights.push_back(static_cast<double>(share) / steps);
    }
  }

  void add_known(const DesignIteration& design) {
    if (design.tasks.size() == tasks_.size() && std::isfinite(design.value))
      known_.push_back(design);
  }

  /// The optimum of one task alone, with the motions of the others.
  void add_alone(std::size_t own, const DesignIteration& best) {
    std::vector<VectorXd> motions;
    for (std::size_t k = 0; k < tasks_.size(); ++k)
      motions.push_back(k == own ? best.tasks.at(0).m : tasks_[k].guess(best.s));
    CodesignOptions still = options_;
    still.motion_only = true;
    add_known(solve(std::vector<double>(tasks_.size(), 1.0), best.s, motions, still));
  }

  std::vector<LatticePoint> take() {
    for (int sweep = 0; sweep < kLatticeSweeps && go_on(); ++sweep) {
      bool changed = false;
      for (LatticePoint& point : points_) changed = improve(point) || changed;
      if (!changed) break;
    }
    for (LatticePoint& point : points_) adopt(point);
    std::erase_if(points_, [](const LatticePoint& point) { return point.best.tasks.empty(); });
    return std::move(points_);
  }

 private:
  bool go_on() const { return !options_.go_on || options_.go_on(); }

  static double value_of(const DesignIteration& design, const std::vector<double>& weights) {
    if (design.tasks.size() != weights.size()) return std::numeric_limits<double>::infinity();
    double sum = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k)
      if (weights[k] > 0.0)
        sum += weights[k] * (design.tasks[k].value + design.tasks[k].outer_value);
    return sum;
  }

  /// The known design that is best at these weights; null where none is.
  const DesignIteration* best_at(const std::vector<double>& weights) const {
    const DesignIteration* best = nullptr;
    for (const DesignIteration& each : known_)
      if (best == nullptr || value_of(each, weights) < value_of(*best, weights)) best = &each;
    return best;
  }

  /// Solves a point from what is known best there, unless that is its own. Corners are known.
  bool improve(LatticePoint& point) {
    const DesignIteration* start = best_at(point.weights);
    if (start == nullptr || !go_on()) return false;
    const double own = value_of(point.best, point.weights), there = value_of(*start, point.weights);
    if (!(there < own - 1e-9 * std::abs(own)) && !point.best.tasks.empty()) return false;
    point.best = *start;
    if (std::count(point.weights.begin(), point.weights.end(), 0.0) + 1 ==
        static_cast<std::ptrdiff_t>(point.weights.size()))
      return true;
    std::vector<VectorXd> motions;
    for (const TaskIterate& task : start->tasks) motions.push_back(task.m);
    const DesignIteration found = solve(point.weights, start->s, motions, options_);
    if (value_of(found, point.weights) < there) {
      point.best = found;
      known_.push_back(found);
    }
    return true;
  }

  void adopt(LatticePoint& point) const {
    const DesignIteration* best = best_at(point.weights);
    if (best != nullptr && value_of(*best, point.weights) < value_of(point.best, point.weights))
      point.best = *best;
    point.best.value = value_of(point.best, point.weights);
  }

  /// Tasks of weight 0 have no say in the body; their motions are solved at it.
  DesignIteration solve(const std::vector<double>& weights, const VectorXd& s,
                        const std::vector<VectorXd>& motions, const CodesignOptions& options) {
    std::vector<WeightedCost> some, all;
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
      all.push_back(weighted(tasks_[k], std::max(weights[k], kLeastWeight), motions[k]));
      if (weights[k] > 0.0) some.push_back(weighted(tasks_[k], weights[k], motions[k]));
    }
    if (some.size() == all.size() || options.motion_only)
      return codesign(all, space_, s, options).best;
    const DesignIteration body = codesign(some, space_, s, options).best;
    if (body.tasks.size() != some.size()) return {};
    std::size_t next = 0;
    for (std::size_t k = 0; k < tasks_.size(); ++k)
      if (weights[k] > 0.0) all[k].initial_motion = body.tasks[next++].m;
    CodesignOptions still = options;
    still.motion_only = true;
    return codesign(all, space_, body.s, still).best;
  }

  static constexpr double kLeastWeight = 1e-3;  // in a sum that only tells motions

  const std::vector<JointTask>& tasks_;
  const DesignSpace& space_;
  CodesignOptions options_;
  std::vector<LatticePoint> points_;
  std::vector<DesignIteration> known_;
};

}  // namespace

std::vector<LatticePoint> lattice_front(const std::vector<JointTask>& tasks,
                                        const DesignSpace& space, const MultistartResult& found,
                                        int steps, const CodesignOptions& options) {
  LatticeFront front(tasks, space, steps, options);
  for (const StartedRun& run : found.joint) front.add_known(run.result.best);
  for (std::size_t k = 0; k < found.alone.size(); ++k)
    if (!found.alone[k].result.best.tasks.empty()) front.add_alone(k, found.alone[k].result.best);
  return front.take();
}

}  // namespace legwright
