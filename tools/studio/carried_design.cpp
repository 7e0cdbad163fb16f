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
  std::vector<std::string> taken, at_bound, fixed, locked, gone;
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
    const double within = std::clamp(value, parameter.lower, parameter.upper);
    names.taken.push_back(name);
    if (within != value) names.at_bound.push_back(name);
    edit.values[name] = within;
  }
  if (!edit.values.empty()) opening.commands.push_back(std::move(edit));
  for (const std::string& name : carried.locked) {
    if (const int i = space.find(name); i < 0) {
      if (!carried.values.contains(name)) names.gone.push_back(name);
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
    const double value = state.s()[static_cast<Eigen::Index>(i)];
    if (value != parameters[i].initial) out.values[parameters[i].name] = value;
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
  if (!names.gone.empty())
    told.push_back(fmt::format("Not taken over, as this robot has no such parameters: {}.",
                               fmt::join(names.gone, ", ")));
  return fmt::format("{}", fmt::join(told, " "));
}

}  // namespace legwright
