// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/state_json.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "optimizer/design/inertia.hpp"
#include "optimizer/terms/registry.hpp"

namespace legwright {
namespace {

Json numbers(const Eigen::VectorXd& v) { return std::vector<double>(v.begin(), v.end()); }

/// Terms that cost something in any task, with their shares of Σ w F.
Json terms_of(const SessionState& state) {
  Json out = Json::array();
  if (state.now->tasks.empty()) return out;
  for (std::size_t t = 0; t < state.now->tasks.front().terms.size(); ++t) {
    double sum = 0.0;
    Json by_task = Json::array();
    for (std::size_t k = 0; k < state.weights.size(); ++k) {
      const double value = state.now->tasks[k].terms[t].value;
      by_task.push_back(value);
      sum += state.weights[k] * value;
    }
    if (sum == 0.0) continue;
    const std::string_view name = state.now->tasks.front().terms[t].name;
    const TermEntry* entry = find_term(name);
    out.push_back({{"name", name},
                   {"words", entry ? entry->cost_label : name},
                   {"value", sum},
                   {"by_task", by_task}});
  }
  return out;
}

double mass_of(const SessionState& state) {
  double mass = 0.0;
  for (const Link& link : state.problem->robot.morphology.links)
    for (const PointMass& point : link.masses) mass += point.mass * point.growth_at(state.s());
  return mass;
}

}  // namespace

Json state_json(const SessionSnapshot& snapshot, int document) {
  const SessionState& state = *snapshot.state;
  const Eigen::VectorXd gradient = state.design_gradient();
  Json task_F = Json::array(), solved = Json::array(), others = Json::array();
  for (const AlternativesPointer& each : snapshot.alternatives)
    if (each->problem == state.problem) others.push_back(to_string(each->kind));
  for (const TaskIterate& task : state.now->tasks) {
    task_F.push_back(task.value);
    solved.push_back(to_string(task.motion_status));
  }
  return {{"revision", snapshot.revision},
          {"document", document},
          {"phase", to_string(snapshot.phase)},
          {"settled", state.settled()},
          {"s", numbers(state.s())},
          {"lower", numbers(state.lower)},
          {"upper", numbers(state.upper)},
          {"frozen", state.frozen},
          {"weights", state.weights},
          {"F", state.value()},
          {"J", state.outer_value()},
          {"task_F", task_F},
          {"motion_status", solved},
          {"terms", terms_of(state)},
          {"mass", mass_of(state)},
          {"gradient", gradient.size() > 0 ? numbers(gradient) : Json(nullptr)},
          {"iterations", state.iterations},
          {"can_undo", snapshot.can_undo},
          {"can_redo", snapshot.can_redo},
          {"alternatives", others},
          {"names", snapshot.names}};
}

Json point_json(const SessionState& before, const SessionState& now) {
  Json changed = Json::array();
  const auto& parameters = now.problem->robot.space.parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (before.s()[at] == now.s()[at]) continue;
    changed.push_back(
        {{"name", parameters[i].name}, {"from", before.s()[at]}, {"to", now.s()[at]}});
  }
  return {{"iteration", now.iterations},
          {"F", now.value()},
          {"terms", terms_of(now)},
          {"changed", changed}};
}

Json comparison_json(const SessionState& a, const SessionState& b) {
  Json rows = Json::array(), tasks = Json::array();
  const auto& parameters = b.problem->robot.space.parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    rows.push_back({{"name", parameters[i].name},
                    {"unit", parameters[i].unit},
                    {"sentence", parameters[i].sentence},
                    {"a", a.s()[at]},
                    {"b", b.s()[at]}});
  }
  for (int k = 0; k < b.problem->task_count(); ++k) {
    Json of_a = nullptr;  // where it has a task of that name
    for (int j = 0; j < a.problem->task_count(); ++j)
      if (a.problem->task(j).name == b.problem->task(k).name)
        of_a = a.now->tasks[static_cast<std::size_t>(j)].value;
    tasks.push_back({{"name", b.problem->task(k).name},
                     {"a", of_a},
                     {"b", b.now->tasks[static_cast<std::size_t>(k)].value}});
  }
  return {{"rows", rows},
          {"tasks", tasks},
          {"F", {{"a", a.value()}, {"b", b.value()}}},
          {"mass", {{"a", mass_of(a)}, {"b", mass_of(b)}, {"unit", "kg"}}}};
}

}  // namespace legwright
