// SPDX-License-Identifier: Apache-2.0
#include "tools/session/alternatives.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "optimizer/solve/fewest_changes.hpp"
#include "optimizer/solve/multistart.hpp"
#include "optimizer/solve/put_back.hpp"
#include "tools/session/weight_lattice.hpp"

namespace legwright {
namespace {

using Eigen::VectorXd;

constexpr int kFrontPoints = 7;    // between the ends of two tasks, besides the present weights
constexpr int kTriangleSteps = 4;  // from corner to corner of three

/// Given values, as far as bounds let them and what is frozen lets go.
VectorXd given_of(const SessionState& state) { return state.space().clamp(state.given); }

/// Costs for each thread, and how they are solved.
class Workshop {
 public:
  Workshop(const SessionState& state, const AlternativeRules& rules)
      : state_(state), rules_(rules), space_(state.space()) {
    for (int thread = 0; thread < std::max(1, rules.threads); ++thread) {
      costs_.push_back(std::make_unique<ProblemCosts>(*state.problem));
      std::vector<WeightedCost>& tasks = tasks_.emplace_back();
      for (std::size_t k = 0; k < state.weights.size(); ++k)
        tasks.push_back(
            weighted(costs_.back()->tasks()[k], state.weights[k], state.now->tasks[k].m));
    }
  }

  const SessionState& state() const { return state_; }
  const DesignSpace& space() const { return space_; }
  const std::vector<std::vector<WeightedCost>>& tasks() const { return tasks_; }
  /// With the weights of the session.
  std::vector<JointTask> joint_tasks() const {
    std::vector<JointTask> out = costs_.front()->tasks();
    for (std::size_t k = 0; k < out.size(); ++k) out[k].weight = state_.weights[k];
    return out;
  }
  bool stopped() const { return rules_.stop(); }

  CodesignOptions options() const {
    CodesignOptions options;
    return with_rules(options);
  }
  CodesignOptions with_rules(CodesignOptions options) const {
    options.threads = rules_.threads;
    options.go_on = options.newton.go_on = [stop = rules_.stop] { return !stop(); };
    options.on_iteration = [rules = rules_](const DesignIteration&) {
      rules.tell();
      return !rules.stop();
    };
    return options;
  }

  /// The motions of a body, and F: nothing else moves.
  DesignIteration solved(const VectorXd& s, const std::vector<VectorXd>& motions) const {
    std::vector<WeightedCost> tasks = tasks_.front();
    for (std::size_t k = 0; k < tasks.size(); ++k) tasks[k].initial_motion = motions[k];
    CodesignOptions still = options();
    still.motion_only = true;
    return codesign(tasks, space_, s, still).best;
  }
  DesignIteration present() const {
    std::vector<VectorXd> motions;
    for (const TaskIterate& task : state_.now->tasks) motions.push_back(task.m);
    return solved(state_.s(), motions);
  }

  VectorXd given() const { return given_of(state_); }

  Alternative alternative(const DesignIteration& design, std::vector<double> weights) const {
    Alternative out;
    out.s = design.s;
    out.weights = std::move(weights);
    for (const TaskIterate& task : design.tasks) {
      out.motions.push_back(task.m);
      out.values.push_back(task.value + task.outer_value);
    }
    for (int k = 0; k < out.s.size(); ++k)
      if (out.s[k] != state_.given[k]) out.changed.push_back(k);
    return out;
  }

 private:
  const SessionState& state_;
  const AlternativeRules& rules_;
  DesignSpace space_;
  std::vector<std::unique_ptr<ProblemCosts>> costs_;
  std::vector<std::vector<WeightedCost>> tasks_;
};

std::vector<ChangeWorth> worths_of(const std::vector<PutBack>& rows, const Workshop& workshop) {
  std::vector<ChangeWorth> out;
  out.reserve(rows.size());
  for (const PutBack& row : rows)
    out.push_back({row.parameter, row.s[row.parameter], row.total(workshop.tasks().front())});
  std::stable_sort(out.begin(), out.end(),
                   [](const ChangeWorth& a, const ChangeWorth& b) { return a.worth > b.worth; });
  return out;
}

/// @return whether it was worked out to the end
bool add_fewest(const Workshop& workshop, Alternatives& out) {
  const VectorXd given = workshop.given();
  const DesignIteration present = workshop.present();
  std::vector<VectorXd> motions;
  for (const JointTask& task : workshop.joint_tasks()) motions.push_back(task.guess(given));
  const DesignIteration before = workshop.solved(given, motions);
  if (workshop.stopped()) return false;
  PutBackOptions rules;
  rules.stop = [&] { return workshop.stopped(); };
  rules.limits.newton.go_on = [&] { return !workshop.stopped(); };
  const std::vector<PutBack> rows = put_back(workshop.tasks(), given, present, rules);
  if (workshop.stopped()) return false;
  FewestChangesOptions options;
  options.codesign = workshop.with_rules(options.codesign);
  options.share = Alternatives::kKept;
  options.stop = rules.stop;
  out.given_value = before.value;
  const std::vector<FewerChanges> designs = fewest_changes(
      workshop.tasks(), workshop.space(), given, before.value, present, rows, options);
  if (workshop.stopped()) return false;
  for (const FewerChanges& each : designs)
    out.designs.push_back(workshop.alternative(each.design, workshop.state().weights));
  out.fewest = fewest_that_keep(designs, before.value, Alternatives::kKept);
  out.worths = worths_of(rows, workshop);
  return true;
}

/// The optimum of each task alone, from the body as it stands.
std::vector<StartedRun> alone(const Workshop& workshop) {
  std::vector<StartedRun> out;
  for (int k = 0; k < static_cast<int>(workshop.tasks().front().size()); ++k) {
    WeightedCost task = workshop.tasks().front()[static_cast<std::size_t>(k)];
    task.weight = 1.0;
    out.push_back({{"initial", {k}},
                   codesign({task}, workshop.space(), workshop.state().s(), workshop.options())});
  }
  return out;
}

bool add_front(const Workshop& workshop, Alternatives& out) {
  const std::vector<JointTask> tasks = workshop.joint_tasks();
  const DesignIteration present = workshop.present();
  MultistartResult found;
  found.alone = alone(workshop);
  found.joint.push_back({{"initial", {}}, {}});
  found.joint.front().result.best = present;
  if (workshop.stopped()) return false;
  if (tasks.size() == 2) {
    for (const FrontPoint& point :
         trade_off_front(tasks, workshop.space(), found, kFrontPoints, workshop.options()))
      out.designs.push_back(workshop.alternative(point.best, {point.weight, 1.0 - point.weight}));
  } else {
    for (const LatticePoint& point :
         lattice_front(tasks, workshop.space(), found, kTriangleSteps, workshop.options()))
      out.designs.push_back(workshop.alternative(point.best, point.weights));
  }
  return !workshop.stopped();
}

}  // namespace

std::string_view to_string(AlternativeKind kind) {
  return kind == AlternativeKind::fewest ? "fewest" : "front";
}

double Alternative::value() const {
  double sum = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * values[k];
  return sum;
}

void check_workable(AlternativeKind kind, const SessionState& state) {
  const std::string what(to_string(kind));
  if (kind == AlternativeKind::fewest && state.s() == given_of(state))
    throw InputError("<session>", 0, what,
                     "the body is as it was given, as far as it is free: there are no changes to "
                     "put back; optimise or edit it first");
  const int tasks = state.problem->task_count();
  if (kind == AlternativeKind::front && tasks != 2 && tasks != 3)
    throw InputError("<session>", 0, what,
                     "tasks are " + std::to_string(tasks) +
                         "; expected two or three, between which there is a trade-off");
}

AlternativesPointer work_out(AlternativeKind kind, const SessionState& state,
                             const AlternativeRules& rules) {
  check_workable(kind, state);
  if (!state.settled())
    throw InputError("<session>", 0, std::string(to_string(kind)),
                     "the motions of this body are not solved, so it cannot be compared; change "
                     "the body or the task");
  const Workshop workshop(state, rules);
  auto out = std::make_shared<Alternatives>();
  out->kind = kind;
  out->problem = state.problem;
  const bool done =
      kind == AlternativeKind::fewest ? add_fewest(workshop, *out) : add_front(workshop, *out);
  if (!done || out->designs.empty()) return nullptr;
  return out;
}

}  // namespace legwright
