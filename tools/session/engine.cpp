// SPDX-License-Identifier: Apache-2.0
#include "tools/session/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "tools/task/design_table.hpp"

namespace legwright {

using Eigen::VectorXd;

/// What evaluates and solves one problem: with memory of its own, so not for several threads.
struct SessionEngine::Costs {
  Costs(std::shared_ptr<const CodesignProblem> which, int threads,
        const std::function<bool()>& stop)
      : problem(std::move(which)),
        solved(*problem, first_motion(threads, stop)),
        shown(*problem),
        motions(solved.tasks(), threads, stop) {}

  static FirstMotionOptions first_motion(int threads, const std::function<bool()>& stop) {
    FirstMotionOptions options;
    options.threads = threads;
    options.go_on = [stop] { return !stop(); };
    return options;
  }

  std::shared_ptr<const CodesignProblem> problem;
  ProblemCosts solved;  // by searches
  ProblemCosts shown;   // between their steps, which lean on what was evaluated last
  DesignMotions motions;
};

SessionEngine::SessionEngine(RobotModel robot, const std::string& text,
                             const std::filesystem::path& file, int threads)
    : robot_(std::move(robot)), file_(file), threads_(threads) {
  if (threads_ <= 0) threads_ = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  TaskSet set = parse_task_tables(text, file);
  set.robot = robot_.file;
  const auto problem =
      std::make_shared<const CodesignProblem>(make_problem(std::move(set), robot_));
  SessionState first;
  first.problem = problem;
  first.given_motions = std::make_shared<GivenMotions>();
  first.given = given_body(robot_.space, problem->set.design);
  VectorXd s = first.given;
  first.lower = robot_.space.lower();
  first.upper = robot_.space.upper();
  for (int i = 0; i < robot_.space.size(); ++i) {
    const DesignParameter& asked = problem->robot.space.parameters[i];
    first.frozen.push_back(asked.frozen());
    if (asked.frozen()) {
      s[i] = asked.initial;
      continue;
    }
    first.lower[i] = std::min(asked.lower, s[i]);
    first.upper[i] = std::max(asked.upper, s[i]);
  }
  for (int k = 0; k < problem->task_count(); ++k) first.weights.push_back(problem->task(k).weight);
  first.cold.assign(first.weights.size(), true);
  state_ = std::make_shared<const SessionState>(first);
  first.now = guessed(first, s);
  state_ = std::make_shared<const SessionState>(std::move(first));
}

void SessionEngine::refuse(const std::string& where, const std::string& message) {
  throw InputError("<session>", 0, where, message);
}

SessionEngine::Costs& SessionEngine::costs() {
  if (!costs_ || costs_->problem != state_->problem)
    costs_ = std::make_shared<Costs>(state_->problem, threads_, [this] { return stop_(); });
  return *costs_;
}

/// F and its terms at a point whose motions need not be solved.
std::shared_ptr<const DesignPoint> SessionEngine::shown(const VectorXd& s,
                                                        std::vector<VectorXd> motions) {
  auto point = std::make_shared<DesignPoint>();
  point->s = s;
  Evaluation at;
  const std::vector<JointTask>& tasks = costs().shown.tasks();
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    TaskIterate task;
    task.m = std::move(motions[k]);
    tasks[k].cost->evaluate(s, task.m, Order::value, at);
    task.value = at.value;
    task.terms = named_terms(*tasks[k].cost, at);
    if (tasks[k].outer) {
      tasks[k].outer->evaluate(s, task.m, Order::value, at);
      task.outer_value = at.value;
    }
    point->tasks.push_back(std::move(task));
  }
  return point;
}

/// First guesses of cold motions; the others as they are.
std::shared_ptr<const DesignPoint> SessionEngine::guessed(const SessionState& state,
                                                          const VectorXd& s) {
  std::vector<VectorXd> motions;
  motions.reserve(state.cold.size());
  for (int k = 0; k < state.problem->task_count(); ++k)
    motions.push_back(state.cold[k] ? initial_guess(*state.problem->objectives[k], s)
                                    : state.now->tasks[k].m);
  return shown(s, std::move(motions));
}

int SessionEngine::find(const std::string& name) const {
  const DesignSpace& space = robot_.space;
  const int k = space.find(name);
  if (k >= 0) return k;
  std::vector<std::string> names;
  for (const DesignParameter& parameter : space.parameters) names.push_back(parameter.name);
  const std::string near = nearest(name, names);
  refuse(name, "the robot has no such design parameter; " +
                   (!near.empty()   ? "is '" + near + "' meant?"
                    : names.empty() ? std::string("it has none at all")
                                    : fmt::format("it has {}", fmt::join(names, ", "))));
}

/// @param goes_on the change belongs to the last one
void SessionEngine::change(SessionState next, bool goes_on) {
  if (!goes_on) history_.leave(state_);
  state_ = std::make_shared<const SessionState>(std::move(next));
  moving_.clear();
}

void SessionEngine::move_to(const VectorXd& s, bool goes_on) {
  SessionState next = *state_;
  const bool cold = std::any_of(next.cold.begin(), next.cold.end(), [](bool c) { return c; });
  if (cold || !next.base)
    next.now = guessed(next, s);
  else
    next.now = shown(s, costs().motions.predict(next.base, s));
  change(std::move(next), goes_on);
}

void SessionEngine::apply(const session::Edit& edit) {
  VectorXd s = state_->s();
  std::vector<std::string> names;
  for (const auto& [name, value] : edit.values) {
    const int i = find(name);
    const std::string& unit = robot_.space.parameters[i].unit;
    if (state_->frozen[i])
      refuse(name, fmt::format("is frozen at {} {}; unfreeze it first", s[i], unit));
    if (!(value >= state_->lower[i] && value <= state_->upper[i]))
      refuse(name, fmt::format("is to be {}; expected {} to {} {}, its bounds", value,
                               state_->lower[i], state_->upper[i], unit));
    s[i] = value;
    names.push_back(name);
  }
  move_to(s, edit.goes_on && names == moving_ && history_.can_undo());
  moving_ = std::move(names);
}

void SessionEngine::apply(const session::Freeze& freeze) {
  SessionState next = *state_;
  for (const std::string& name : freeze.names) {
    const int i = find(name);
    next.frozen[i] = freeze.frozen;
  }
  change(std::move(next));
}

void SessionEngine::apply(const session::Bounds& bounds) {
  const int i = find(bounds.name);
  const DesignParameter& parameter = robot_.space.parameters[i];
  const double value = state_->s()[i];
  if (!(bounds.lower >= parameter.lower && bounds.lower <= value && value <= bounds.upper &&
        bounds.upper <= parameter.upper))
    refuse(bounds.name,
           fmt::format("bounds are to be {} to {}; expected them within the robot's, {} to {} {}, "
                       "around the present value {}",
                       bounds.lower, bounds.upper, parameter.lower, parameter.upper, parameter.unit,
                       value));
  SessionState next = *state_;
  next.lower[i] = bounds.lower;
  next.upper[i] = bounds.upper;
  change(std::move(next));
}

void SessionEngine::apply(const session::Tasks& tasks) {
  const std::filesystem::path told = tasks.file;
  TaskSet set = parse_task_tables(tasks.text, told.empty() ? file_ : told);
  set.robot = robot_.file;
  set.design = {};
  SessionState next = *state_;
  const auto problem =
      std::make_shared<const CodesignProblem>(make_problem(std::move(set), robot_));
  const VectorXd s = state_->s();
  next.problem = problem;
  next.given_motions = std::make_shared<GivenMotions>();
  next.weights.clear();
  next.cold.clear();
  next.base = nullptr;
  std::vector<VectorXd> motions;
  for (int k = 0; k < problem->task_count(); ++k) {
    next.weights.push_back(problem->task(k).weight);
    const Objective& objective = *problem->objectives[k];
    int same = -1;  // the task of this name so far
    for (int j = 0; j < state_->problem->task_count(); ++j)
      if (state_->problem->task(j).name == problem->task(k).name) same = j;
    const bool warm = same >= 0 && !state_->cold[same] &&
                      same_layout(*state_->problem->objectives[same], objective);
    next.cold.push_back(!warm);
    motions.push_back(warm ? state_->now->tasks[same].m : initial_guess(objective, s));
  }
  change(std::move(next));
  next = *state_;
  next.now = shown(s, std::move(motions));  // by the new costs
  state_ = std::make_shared<const SessionState>(std::move(next));
}

void SessionEngine::apply(const session::Weights& weights) {
  if (state_->weights.size() < 2) refuse("weights", "there is one task; they are between several");
  if (weights.weights.size() != state_->weights.size())
    refuse("weights", fmt::format("are {}; expected one for each of the {} tasks",
                                  weights.weights.size(), state_->weights.size()));
  for (const double weight : weights.weights)
    if (!(weight > 0.0) || !std::isfinite(weight))
      refuse("weights", fmt::format("one is {}; expected numbers above 0", weight));
  SessionState next = *state_;
  next.weights = weights.weights;
  change(std::move(next));
}

void SessionEngine::apply(const session::Reset&) {
  SessionState next = *state_;
  next.cold.assign(next.cold.size(), true);
  next.base = nullptr;
  next.iterations = 0;
  next.lower = next.lower.cwiseMin(next.given);
  next.upper = next.upper.cwiseMax(next.given);
  next.now = guessed(next, next.given);
  change(std::move(next));
}

void SessionEngine::apply(const session::Undo&) {
  if (!history_.can_undo()) refuse("undo", "there is nothing to undo");
  state_ = history_.undo(state_);
  moving_.clear();
}

void SessionEngine::apply(const session::Redo&) {
  if (!history_.can_redo()) refuse("redo", "there is nothing to redo");
  state_ = history_.redo(state_);
  moving_.clear();
}

void SessionEngine::apply(const session::Snapshot& snapshot) {
  if (snapshot.name.empty()) refuse("snapshot", "has no name; give it one");
  history_.name(snapshot.name, state_);
}

void SessionEngine::apply(const session::Branch& branch) {
  const StatePointer from = history_.named(branch.name);
  if (!from) {
    const std::vector<std::string> names = history_.names();
    refuse(branch.name, names.empty()
                            ? std::string("is no snapshot; there are none yet")
                            : fmt::format("is no snapshot; there are {}", fmt::join(names, ", ")));
  }
  change(*from);
}

void SessionEngine::apply(const SessionCommand& command) {
  std::visit([this](const auto& each) { apply(each); }, command);
}

/// Best first motions in the place of guesses. False where stopped.
bool SessionEngine::warm_up() {
  const auto is_cold = [](bool c) { return c; };
  if (std::none_of(state_->cold.begin(), state_->cold.end(), is_cold)) return true;
  SessionState next = *state_;
  std::vector<VectorXd> motions;
  for (std::size_t k = 0; k < next.cold.size(); ++k)
    motions.push_back(next.cold[k] ? costs().solved.tasks()[k].guess(next.s())
                                   : next.now->tasks[k].m);
  if (stop_()) return false;
  next.cold.assign(next.cold.size(), false);
  next.now = shown(next.s(), std::move(motions));
  state_ = std::make_shared<const SessionState>(std::move(next));
  return true;
}

bool SessionEngine::settle() {
  const StatePointer before = state_;
  if (warm_up()) {
    SessionState next = *state_;
    std::vector<VectorXd> motions;
    for (const TaskIterate& task : next.now->tasks) motions.push_back(task.m);
    if (auto point = costs().motions.settle(next.s(), motions)) {
      next.now = next.base = std::move(point);
      state_ = std::make_shared<const SessionState>(std::move(next));
      keep_given(*before);
      return true;
    }
  }
  state_ = before;
  return false;
}

/// Motions that settle() found, as the point that it led to; null where F is not finite there.
std::shared_ptr<const DesignPoint> SessionEngine::adopted(const Found& found) {
  return costs().motions.adopt(found.s, found.motions, found.status);
}

/// The given body's motions, where those are what was solved for, from nothing.
void SessionEngine::keep_given(const SessionState& before) {
  const bool cold = std::all_of(before.cold.begin(), before.cold.end(), [](bool c) { return c; });
  if (!cold || before.s() != before.problem->robot.space.initial()) return;
  if (auto found = found_in(*state_))
    state_->given_motions->set({std::move(found->motions), std::move(found->status)});
}

SearchRules SessionEngine::rules() {
  SearchRules rules;
  rules.threads = threads_;
  rules.stop = [this] { return stop_(); };
  return rules;
}

std::vector<WeightedCost> SessionEngine::weighted_costs() {
  std::vector<WeightedCost> out;
  const std::vector<JointTask>& tasks = costs().solved.tasks();
  for (std::size_t k = 0; k < tasks.size(); ++k)
    out.push_back(weighted(tasks[k], state_->weights[k], state_->now->tasks[k].m));
  return out;
}

SearchEnd SessionEngine::search(int most, const std::function<void()>& tell) {
  const StatePointer before = state_;
  if (!warm_up()) return {0, SolveStatus::stopped};
  SearchRules how = rules();
  how.most = most;
  how.tell = [&](const JointPoint& point) {
    SessionState next = *state_;
    next.now = shown(point.s, point.motions);
    ++next.iterations;
    state_ = std::make_shared<const SessionState>(std::move(next));
    if (tell) tell();
  };
  const DesignSpace space = state_->space();
  SearchEnd end;
  try {
    end = search_on(weighted_costs(), space, state_->s(), how);
  } catch (...) {
    state_ = before;
    throw;
  }
  if (end.points == 0) {
    state_ = before;
    return end;
  }
  history_.leave(before);
  moving_.clear();
  return end;
}

bool SessionEngine::step() {
  const StatePointer before = state_;
  if (warm_up()) {
    const DesignSpace space = state_->space();
    JointPoint point = step_on(weighted_costs(), space, state_->s(), rules());
    if (!point.motions.empty()) {
      SessionState next = *state_;
      next.now = shown(point.s, std::move(point.motions));
      ++next.iterations;
      state_ = before;
      change(std::move(next));
      return true;
    }
  }
  state_ = before;
  return false;
}

}  // namespace legwright
