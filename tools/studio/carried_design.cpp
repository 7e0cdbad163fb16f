// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/carried_design.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "mjcf/text/input_error.hpp"
#include "tools/task/task_text.hpp"

namespace legwright {
namespace {

/// What became of the parameters, by their names.
struct CarriedNames {
  std::vector<std::string> taken, at_bound, fixed, locked, narrowed, apart, gone;
};

/// @return why the tasks do not fit; empty where they do, and were taken
std::string take_tasks(const std::string& text, Opening& opening) {
  std::string first = std::exchange(opening.text, text);
  try {
    (void)check_fit(opening);
    return {};
  } catch (const InputError& error) {
    opening.text = std::move(first);
    return error.message();
  }
}

/// Whether bounds of before have a value that the robot's let.
bool meet(const std::pair<double, double>& before, const DesignParameter& parameter) {
  return before.first <= parameter.upper && before.second >= parameter.lower;
}

/// The bounds of before, as far as the robot's let them; the robot's where the two do not meet.
std::pair<double, double> bounds_for(const DesignParameter& parameter,
                                     const CarriedDesign& carried) {
  const auto found = carried.bounds.find(parameter.name);
  if (found == carried.bounds.end() || !meet(found->second, parameter))
    return {parameter.lower, parameter.upper};
  return {std::clamp(found->second.first, parameter.lower, parameter.upper),
          std::clamp(found->second.second, parameter.lower, parameter.upper)};
}

/// Narrows bounds as before, no further than to the value that stands.
/// @param values that are not the given ones
void take_bounds(const CarriedDesign& carried, const DesignSpace& space,
                 const std::map<std::string, double>& values, Opening& opening,
                 CarriedNames& names) {
  for (const auto& [name, before] : carried.bounds) {
    const int i = space.find(name);
    if (i < 0) {
      if (!carried.values.contains(name)) names.gone.push_back(name);
      continue;
    }
    const DesignParameter& parameter = space.parameters[static_cast<std::size_t>(i)];
    if (parameter.frozen()) continue;
    if (!meet(before, parameter)) {
      names.apart.push_back(name);
      continue;
    }
    const auto found = values.find(name);
    const double value = found == values.end() ? parameter.initial : found->second;
    const auto [lower, upper] = bounds_for(parameter, carried);
    const session::Bounds bounds{name, std::min(lower, value), std::max(upper, value)};
    if (bounds.lower == parameter.lower && bounds.upper == parameter.upper) continue;
    names.narrowed.push_back(name);
    opening.commands.push_back(bounds);
  }
}

CarriedNames take_values(const CarriedDesign& carried, Opening& opening) {
  CarriedNames names;
  session::Edit edit;
  const DesignSpace space = check_fit(opening);
  for (const auto& [name, value] : carried.values) {
    const int i = space.find(name);
    if (i < 0) {
      names.gone.push_back(name);
      continue;
    }
    const DesignParameter& parameter = space.parameters[static_cast<std::size_t>(i)];
    if (parameter.frozen()) {
      names.fixed.push_back(name);
      continue;
    }
    const auto [lower, upper] = bounds_for(parameter, carried);
    const double within = std::clamp(value, lower, upper);
    names.taken.push_back(name);
    if (within != value) names.at_bound.push_back(name);
    edit.values[name] = within;
  }
  const std::map<std::string, double> now = edit.values;
  if (!edit.values.empty()) opening.commands.push_back(std::move(edit));
  take_bounds(carried, space, now, opening, names);
  for (const std::string& name : carried.locked) {
    if (const int i = space.find(name); i < 0) {
      if (!carried.values.contains(name) && !carried.bounds.contains(name))
        names.gone.push_back(name);
    } else if (!space.parameters[static_cast<std::size_t>(i)].frozen()) {
      names.locked.push_back(name);
    }
  }
  if (!names.locked.empty()) opening.commands.push_back(session::Freeze{names.locked});
  return names;
}

}  // namespace

CarriedDesign carried_of(const SessionState& state, const std::string& opened_text) {
  CarriedDesign out;
  const TaskSet& set = state.problem->set;
  if (set.text != opened_text)
    out.text = set.joint() ? with_weights(set.text, state.weights) : set.text;
  const auto& parameters = state.problem->robot.space.parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const double value = state.s()[at];
    if (value != parameters[i].initial) out.values[parameters[i].name] = value;
    if (!parameters[i].frozen() &&
        (state.lower[at] > parameters[i].lower || state.upper[at] < parameters[i].upper))
      out.bounds[parameters[i].name] = {state.lower[at], state.upper[at]};
    if (state.frozen[i] && !parameters[i].frozen()) out.locked.push_back(parameters[i].name);
  }
  return out;
}

std::string carry_over(const CarriedDesign& carried, Opening& opening) {
  std::vector<std::string> told;
  if (!carried.text.empty()) {
    const std::string why = take_tasks(carried.text, opening);
    told.push_back(why.empty() ? "The task is that of before."
                               : "The task is a first one again; that of before does not fit this "
                                 "robot: " +
                                     why);
  }
  const CarriedNames names = take_values(carried, opening);
  if (!names.taken.empty())
    told.push_back(fmt::format("Values of before: {}.", fmt::join(names.taken, ", ")));
  if (!names.at_bound.empty())
    told.push_back(fmt::format("At their new bounds: {}.", fmt::join(names.at_bound, ", ")));
  if (!names.fixed.empty())
    told.push_back(fmt::format("Not taken over, as this robot or its task holds them: {}.",
                               fmt::join(names.fixed, ", ")));
  if (!names.locked.empty())
    told.push_back(fmt::format("Locked as before: {}.", fmt::join(names.locked, ", ")));
  if (!names.narrowed.empty())
    told.push_back(fmt::format("Bounds as before: {}.", fmt::join(names.narrowed, ", ")));
  if (!names.apart.empty())
    told.push_back(fmt::format("Bounds of before that lie beyond those of this robot: {}.",
                               fmt::join(names.apart, ", ")));
  if (!names.gone.empty())
    told.push_back(fmt::format("Not taken over, as this robot has no such parameters: {}.",
                               fmt::join(names.gone, ", ")));
  return fmt::format("{}", fmt::join(told, " "));
}

}  // namespace legwright
