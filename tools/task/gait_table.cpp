// SPDX-License-Identifier: Apache-2.0
#include "tools/task/gait_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mjcf/text/nearest_word.hpp"
#include "mjcf/text/refusals.hpp"

namespace legwright {
namespace {

constexpr int kFewestStance = 2;  // [knots] with one alone a foot pushes for no time
constexpr const char* kPlaces = "front to hind, left before right";

/// Numbers by foot name as numbers by place.
std::vector<double> by_place(const TaskFile& file, const std::string& key,
                             const std::map<std::string, double>& by_name,
                             const std::vector<std::string>& names, const std::vector<int>& order) {
  Refusals reasons;
  for (const auto& [name, value] : by_name)
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      const std::string guess = nearest(name, names);
      reasons.add(
          file.refusal(fmt::format("{}.{}", key, name),
                       fmt::format("the robot has no such foot; {}its feet are {}",
                                   guess.empty() ? "" : fmt::format("did you mean '{}'? ", guess),
                                   fmt::join(names, ", "))));
    }
  reasons.throw_if_any();
  std::vector<double> values;
  for (int foot : order) {
    const auto found = by_name.find(names[static_cast<std::size_t>(foot)]);
    if (found == by_name.end())
      file.refuse(key, fmt::format("no entry for the foot '{}'; the robot's feet are {}",
                                   names[static_cast<std::size_t>(foot)], fmt::join(names, ", ")));
    values.push_back(found->second);
  }
  return values;
}

GaitPattern library_pattern(const TaskFile& file, int foot_count) {
  std::vector<std::string> names;
  for (GaitPattern& pattern : gait_library(foot_count)) {
    if (pattern.name == file.gait) return pattern;
    names.push_back(pattern.name);
  }
  if (names.empty())
    file.refuse(
        "gait.name",
        fmt::format("the library has no gait for {} feet; give gait.touchdown and gait.duty",
                    foot_count));
  std::string others;  // feet for which there is a gait of that name
  for (const int feet : gait_library_feet())
    for (const GaitPattern& pattern : gait_library(feet))
      if (pattern.name == file.gait)
        others += fmt::format("{}{}", others.empty() ? "" : ", ", feet);
  const std::string guess = others.empty() ? nearest(file.gait, names) : "";
  file.refuse(
      "gait.name",
      fmt::format("'{}' is not in the library{}; {}for {} feet it has {}; or give "
                  "gait.touchdown and gait.duty; `legwright gaits` draws them",
                  file.gait,
                  others.empty() ? "" : fmt::format(" for this robot, only for {} feet", others),
                  guess.empty() ? "" : fmt::format("did you mean '{}'? ", guess), foot_count,
                  fmt::join(names, ", ")));
}

/// A pattern of one's own must not go by the name of another: verdicts and reports call it by that.
void check_own_name(const TaskFile& file, const GaitPattern& own) {
  for (const GaitPattern& pattern : gait_library(static_cast<int>(own.touchdown.size()))) {
    if (pattern.name != own.name) continue;
    for (std::size_t place = 0; place < own.touchdown.size(); ++place)
      if (std::abs(own.touchdown[place] - pattern.touchdown[place]) > kPhaseTolerance)
        file.refuse(
            "gait.name",
            fmt::format("'{0}' is a gait of the library and touches down at {1}, not at {2}; "
                        "name this one differently, for instance \"my_{0}\", or leave "
                        "gait.touchdown out",
                        own.name, fmt::join(pattern.touchdown, ", "),
                        fmt::join(own.touchdown, ", ")));
  }
}

void check_count(const TaskFile& file, const std::string& key, std::size_t count,
                 std::size_t foot_count, const char* what) {
  if (count != foot_count)
    file.refuse(key, fmt::format("has {} entries; the robot has {} feet: give one {} for each, {}",
                                 count, foot_count, what, kPlaces));
}

GaitPattern choose_pattern(const TaskFile& file, const std::vector<std::string>& names,
                           const std::vector<int>& order) {
  const std::size_t foot_count = names.size();
  GaitPattern pattern;
  if (!file.touchdown_by_foot.empty() || !file.touchdown.empty()) {
    pattern.name = file.gait;
    pattern.touchdown = file.touchdown.empty()
                            ? by_place(file, "gait.touchdown", file.touchdown_by_foot, names, order)
                            : file.touchdown;
    check_count(file, "gait.touchdown", pattern.touchdown.size(), foot_count, "phase");
    check_own_name(file, pattern);
  } else {
    pattern = library_pattern(file, static_cast<int>(foot_count));
  }
  if (file.duty) pattern.duty = *file.duty;
  if (!file.duty_by_foot.empty())
    pattern.foot_duty = by_place(file, "gait.duty", file.duty_by_foot, names, order);
  if (!file.foot_duty.empty()) pattern.foot_duty = file.foot_duty;
  if (!pattern.foot_duty.empty())
    check_count(file, "gait.duty", pattern.foot_duty.size(), foot_count, "duty");
  return pattern;
}

/// Knots of the cycle on which the foot of a place stands.
int stance_knots(const GaitPattern& pattern, std::size_t place, int knot_count) {
  int stance = 0;
  for (int knot = 0; knot < knot_count; ++knot)
    stance += pattern.stands(place, static_cast<double>(knot) / knot_count);
  return stance;
}

}  // namespace

void read_gait(TaskTable in, TaskFile& task) {
  task.gait = in.text("name").value_or("");
  const auto period = in.number("period");
  in.require(period.has_value(), "period", "period = 1.0  # s");
  task.period = period.value_or(1.0);
  task.knots = in.integer("knots").value_or(task.knots);
  const toml::node* duty = in.node("duty");
  if (duty && duty->is_table())
    task.duty_by_foot = in.numbers_by_name("duty");
  else if (duty && duty->is_array())
    task.foot_duty = in.numbers("duty").value_or(std::vector<double>{});
  else
    task.duty = in.number("duty");
  const toml::node* touchdown = in.node("touchdown");
  if (touchdown && touchdown->is_table())
    task.touchdown_by_foot = in.numbers_by_name("touchdown");
  else
    task.touchdown = in.numbers("touchdown").value_or(std::vector<double>{});
  if (touchdown)
    in.require(in.has("duty"), "duty", "duty = 0.75  # share of the cycle on the ground");
  else
    in.require(in.has("name"), "name", "name = \"walk\"");
  if (task.gait.empty()) task.gait = "own";
  in.finish();
}

Gait make_gait(const TaskFile& file, const std::vector<std::string>& names,
               const std::vector<int>& order) {
  const GaitPattern pattern = choose_pattern(file, names, order);
  for (std::size_t place = 0; place < order.size(); ++place) {
    const int stance = stance_knots(pattern, place, file.knots);
    if (stance >= kFewestStance) continue;
    file.refuse(
        file.lines.contains("gait.duty") ? "gait.duty" : "gait.knots",
        fmt::format("a duty of {} on {} knots leaves the foot '{}' no stance: {} on the ground, "
                    "{} are needed; raise the duty to {:.3f} or the number of knots",
                    pattern.duty_of(place), file.knots,
                    names[static_cast<std::size_t>(order[place])],
                    stance == 1 ? "a single knot" : "no knot", kFewestStance,
                    std::ceil(1000.0 * kFewestStance / file.knots) / 1000.0));
  }
  return Gait(pattern, file.period, file.knots, order);
}

double longest_duty(const TaskFile& file, const std::vector<std::string>& names,
                    const std::vector<int>& order) {
  const GaitPattern pattern = choose_pattern(file, names, order);
  double longest = 0.0;
  for (std::size_t place = 0; place < order.size(); ++place)
    longest = std::max(longest, pattern.duty_of(place));
  return longest;
}

}  // namespace legwright
