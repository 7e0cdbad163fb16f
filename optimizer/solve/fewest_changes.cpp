// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/fewest_changes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "optimizer/solve/predictor.hpp"
#include "optimizer/solve/put_back.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr int kGlanceIterations = 6;  // of a motion that is only compared with others
constexpr int kRefitIterations = 30;  // of a motion while the rest is optimised again
constexpr double kWorthless = 0.5;    // of the fall of F: designs that keep less end the sequence
constexpr double kBeyond = 0.1;       // of the fall of F: several at once, where few are left
constexpr double kDear = 0.02;        // of the fall of F: a step that costs more is chosen anew
constexpr double kStillToCome = 4.0;  // × what the last step brought: more is not hoped for
constexpr std::size_t kFew = 6;       // so many changes are put back one by one, costs known anew

std::vector<int> changed_parameters_of(const VectorXd& s, const VectorXd& old_values) {
  std::vector<int> changed;
  for (int k = 0; k < s.size(); ++k)
    if (s[k] != old_values[k]) changed.push_back(k);
  return changed;
}

std::vector<WeightedCost> from_motions(std::vector<WeightedCost> tasks,
                                       const DesignIteration& design) {
  for (std::size_t i = 0; i < tasks.size(); ++i) tasks[i].initial_motion = design.tasks[i].m;
  return tasks;
}

/// Parameters of the rows, those that cost least to put back first.
std::vector<int> cheapest_first(const std::vector<PutBack>& rows,
                                const std::vector<WeightedCost>& tasks) {
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> cost;
  for (const PutBack& row : rows) {
    cost.push_back(row.total(tasks));
    if (std::isnan(cost.back())) cost.back() = std::numeric_limits<double>::infinity();
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cost[a] < cost[b]; });
  std::vector<int> parameters;
  parameters.reserve(order.size());
  for (const std::size_t k : order) parameters.push_back(rows[k].parameter);
  return parameters;
}

std::vector<int> first_of(const std::vector<int>& order, std::size_t count) {
  return {order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// What several changes may cost that go at once: half of the room to the share of the fall that is
/// looked for, so that it is not passed in one leap; beyond it the sequence only tells the rest.
double allowed_at_once(const FewestChangesOptions& options, double fall, double lost) {
  const double room = (1.0 - options.share) * fall - lost;
  return room > 0.0 ? std::max(options.free_share * fall, 0.5 * room) : kBeyond * fall;
}

/// The motions of `design` carried to other parameters by dm/ds, eq (4), and bent to eq (12), where
/// that is known and lowers F.
void predict_motions(const std::vector<WeightedCost>& tasks, const VectorXd& s,
                     DesignIteration& design) {
  Evaluation stay, ahead;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    TaskIterate& task = design.tasks[i];
    if (task.sensitivity.cols() != s.size() || task.sensitivity.rows() != task.m.size()) continue;
    VectorXd there = task.m + task.sensitivity * (s - design.s);
    tasks[i].cost->evaluate(s, task.m, Order::value, stay);
    const PredictedValue carried =
        bend_prediction(*tasks[i].cost, design.s, task.m, s, there, ahead);
    if (carried.value < stay.value) task.m = std::move(there);
  }
}

/// `from` without some of its changes, the rest optimised again, as far as F may still come below
/// `most`; a design left early has an infinite F.
FewerChanges without(const FewerChanges& from, const std::vector<int>& back,
                     const std::vector<WeightedCost>& tasks, const DesignSpace& space,
                     const VectorXd& old_values, double initial_value, double most,
                     CodesignOptions options) {
  FewerChanges out = from;
  VectorXd s = from.design.s;
  for (const int k : back) {
    std::erase(out.changed, k);
    s[k] = old_values[k];
  }
  predict_motions(tasks, s, out.design);
  out.design.s = s;
  if (tasks.size() == 1 && tasks[0].outer == nullptr)  // else F of a task alone tells nothing
    options.newton.value_ceiling = initial_value / tasks[0].weight;
  double before = initial_value;
  bool hopeless = false;
  options.on_iteration = [&](const DesignIteration& now) {
    const double fallen = before - now.value;
    hopeless =
        !(now.value < initial_value) || (now.index > 0 && now.value - kStillToCome * fallen > most);
    before = now.value;
    return !hopeless;
  };
  out.design = settle(tasks, space, old_values, out, options).best;
  if (hopeless) out.design.value = std::numeric_limits<double>::infinity();
  return out;
}

}  // namespace

DesignSpace held_space(DesignSpace space, const VectorXd& old_values,
                       const std::vector<int>& changed) {
  for (int k = 0; k < space.size(); ++k)
    if (std::find(changed.begin(), changed.end(), k) == changed.end())
      space.parameters[k].lower = space.parameters[k].upper = old_values[k];
  return space;
}

CodesignOptions FewestChangesOptions::refit_options() {
  CodesignOptions options;
  options.max_iterations = 4;
  options.near_optimum = true;
  options.value_tolerance = 1e-3;
  options.final_tolerance = options.motion_tolerance;
  options.motion_iterations = kRefitIterations;
  options.trial_iterations = kRefitIterations / 2;
  options.line_search_steps = 3;
  return options;
}

CodesignResult settle(const std::vector<WeightedCost>& tasks, const DesignSpace& space,
                      const VectorXd& old_values, const FewerChanges& design,
                      const CodesignOptions& options) {
  return codesign(from_motions(tasks, design.design), held_space(space, old_values, design.changed),
                  design.design.s, options);
}

std::vector<FewerChanges> fewest_changes(const std::vector<std::vector<WeightedCost>>& threads,
                                         const DesignSpace& space, const VectorXd& old_values,
                                         double initial_value, const DesignIteration& result,
                                         const std::vector<PutBack>& rows_of_result,
                                         const FewestChangesOptions& options) {
  const std::vector<WeightedCost>& tasks = threads.front();
  const auto stopped = [&] { return options.stop && options.stop(); };
  std::vector<FewerChanges> designs;
  designs.push_back({changed_parameters_of(result.s, old_values), result});
  const double fall = initial_value - result.value;
  PutBackOptions rules;
  rules.limits = options.codesign;
  rules.stop = options.stop;
  CodesignOptions refit = options.codesign;
  int solved = 0;  // refits and lists of rows: the names of their checkpoints
  rules.limits.trial_iterations = kGlanceIterations;
  std::vector<int> order = cheapest_first(rows_of_result, tasks);
  std::size_t batch = designs.back().changed.size();
  bool known_anew = true;  // the order is of this very design
  while (designs.back().changed.size() > 1 && !stopped()) {
    const std::vector<int>& changed = designs.back().changed;
    const std::size_t count = changed.size();
    std::erase_if(order, [&](int k) {
      return std::find(changed.begin(), changed.end(), k) == changed.end();
    });
    if (order.size() < count || count <= kFew) {  // a stop leaves rows out
      rules.limits.checkpoint = options.codesign.checkpoint.in(solved++);
      const std::vector<PutBack> rows = put_back(threads, old_values, designs.back().design, rules);
      if (stopped() || rows.size() < count) break;
      order = cheapest_first(rows, tasks);
      known_anew = true;
    }
    const double lost = designs.back().design.value - result.value;
    if (lost > (1.0 - options.share) * fall) batch = std::max(2 * batch, count / 4);
    batch = count > kFew ? std::clamp<std::size_t>(batch, 1, std::min(count / 2, count - kFew)) : 1;
    for (;; batch /= 2) {
      const double most = batch > 1     ? allowed_at_once(options, fall, lost)
                          : !known_anew ? kDear * fall
                                        : std::numeric_limits<double>::infinity();
      refit.checkpoint = options.codesign.checkpoint.in(solved++);
      FewerChanges next = without(designs.back(), first_of(order, batch), tasks, space, old_values,
                                  initial_value, designs.back().design.value + most, refit);
      if (stopped()) return designs;
      const double cost = next.design.value - designs.back().design.value;
      if (batch > 1 && !(cost <= most)) continue;
      if (!known_anew && !(cost <= most)) {
        order.clear();  // what was cheap beside other changes is dear now
        break;
      }
      // What a refit leaves at its old value is no change.
      next.changed = changed_parameters_of(next.design.s, old_values);
      if (!std::isfinite(next.design.value)) return designs;
      designs.push_back(std::move(next));
      known_anew = false;
      break;
    }
    if (designs.back().design.value > initial_value - kWorthless * fall) break;
  }
  return designs;
}

std::size_t fewest_that_keep(const std::vector<FewerChanges>& designs, double initial_value,
                             double share) {
  const double most = initial_value - share * (initial_value - designs.front().design.value);
  for (std::size_t k = designs.size(); k-- > 1;)
    if (designs[k].design.value <= most) return k;
  return 0;
}

}  // namespace legwright
