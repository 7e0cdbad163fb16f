// SPDX-License-Identifier: Apache-2.0
#include "tools/task/design_table.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "mjcf/text/refusals.hpp"

namespace legwright {
namespace {

std::vector<std::string> names_in(const DesignSpace& space) {
  std::vector<std::string> names;
  for (const DesignParameter& parameter : space.parameters) names.push_back(parameter.name);
  return names;
}

/// Position of a parameter in s, or an error that offers the nearest name.
int find_parameter(const DesignSpace& space, const std::string& name, const std::string& key,
                   Problems& problems, int line) {
  const int k = space.find(name);
  if (k >= 0) return k;
  const std::vector<std::string> names = names_in(space);
  const std::string near = nearest(name, names);
  problems.add(line, key,
               fmt::format("the robot has no design parameter '{}'; {}", name,
                           !near.empty()   ? fmt::format("is '{}' meant?", near)
                           : names.empty() ? std::string("it has none at all, remove the key")
                                           : fmt::format("it has {}", fmt::join(names, ", "))));
  return -1;
}

/// Positions in s of what [design] freeze names: a parameter, or a pattern of names.
std::vector<int> find_frozen(const DesignSpace& space, const std::string& name, Problems& problems,
                             int line) {
  const std::string key = "design.freeze";
  if (space.size() == 0 || name.find_first_of("*?[") == std::string::npos) {
    const int k = find_parameter(space, name, key, problems, line);
    return k >= 0 ? std::vector<int>{k} : std::vector<int>{};
  }
  std::vector<int> found;
  for (int k = 0; k < space.size(); ++k)
    if (::fnmatch(name.c_str(), space.parameters[k].name.c_str(), 0) == 0) found.push_back(k);
  if (found.empty())
    problems.add(line, key,
                 fmt::format("no design parameter of the robot is like '{}'; the nearest: {}", name,
                             fmt::join(nearest_to_pattern(name, names_in(space)), ", ")));
  return found;
}

}  // namespace

DesignTable read_design_table(TaskTable in, Problems& problems) {
  DesignTable table;
  if (const toml::node* node = in.node("freeze")) {
    const toml::array* array = node->as_array();
    bool good = array != nullptr;
    for (std::size_t i = 0; array && i < array->size(); ++i) {
      const auto name = array->get(i)->value<std::string>();
      good = good && name.has_value();
      if (name) table.freeze.push_back(*name);
    }
    if (!good)
      problems.add(in.line_of("freeze"), in.full("freeze"),
                   "expected names of design parameters, or patterns of them: freeze = "
                   "[\"body_width\", \"front_*\"]");
  }
  table.bounds = in.numbers_of_names("bounds");
  table.given = in.numbers_by_name("given");
  in.finish();
  return table;
}

DesignSpace restricted(const DesignSpace& space, const DesignTable& table, const std::string& file,
                       const std::map<std::string, int>& lines) {
  DesignSpace out = space;
  Problems problems(file);
  const auto line = [&](const std::string& key) {
    const auto found = lines.find(key);
    return found == lines.end() ? 0 : found->second;
  };
  for (const auto& [name, bounds] : table.bounds) {
    const std::string key = "design.bounds." + name;
    const int k = find_parameter(space, name, key, problems, line(key));
    if (k < 0) continue;
    DesignParameter& parameter = out.parameters[k];
    if (!(bounds[0] >= parameter.lower && bounds[0] <= parameter.initial &&
          parameter.initial <= bounds[1] && bounds[1] <= parameter.upper)) {
      problems.add(
          line(key), key,
          fmt::format("is [{}, {}]; expected bounds within the robot's, {} to {}, around "
                      "its value {}",
                      bounds[0], bounds[1], parameter.lower, parameter.upper, parameter.initial));
      continue;
    }
    parameter.lower = bounds[0];
    parameter.upper = bounds[1];
  }
  for (const std::string& name : table.freeze) {
    for (const int k : find_frozen(space, name, problems, line("design.freeze"))) {
      DesignParameter& parameter = out.parameters[k];
      parameter.lower = parameter.upper = parameter.initial;
    }
  }
  for (const auto& [name, value] : table.given) {
    const std::string key = "design.given." + name;
    const int k = find_parameter(space, name, key, problems, line(key));
    if (k < 0) continue;
    const DesignParameter& robots = space.parameters[k];
    if (value < robots.lower || value > robots.upper)
      problems.add(line(key), key,
                   fmt::format("is {}; expected a value within the robot's bounds, {} to {}", value,
                               robots.lower, robots.upper));
  }
  Refusals reasons;
  for (const InputError& problem : problems.all()) reasons.add(problem);
  reasons.throw_if_any();
  return out;
}

Eigen::VectorXd given_body(const DesignSpace& space, const DesignTable& table) {
  Eigen::VectorXd s = space.initial();
  for (const auto& [name, value] : table.given)
    if (const int k = space.find(name); k >= 0) s[k] = value;
  return s;
}

}  // namespace legwright
