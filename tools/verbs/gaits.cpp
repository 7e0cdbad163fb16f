// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "mjcf/text/input_error.hpp"
#include "mjcf/text/nearest_word.hpp"
#include "optimizer/motion/gait.hpp"
#include "tools/files/json_file.hpp"
#include "tools/task/toml_reader.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

constexpr int kColumns = 60;  // per cycle: thirds, quarters and tenths fall on whole columns

struct GaitsOptions {
  std::string name;
  int feet = 0;  // 0: all
  bool json = false;
};

struct Entry {
  int foot_count;
  GaitPattern pattern;
};

/// The gaits that are asked for: of that name, else those whose names contain it. Throws InputError
/// where there are none.
std::vector<Entry> choose(const GaitsOptions& options) {
  std::vector<Entry> exact, alike;
  std::vector<std::string> names;
  for (const int feet : gait_library_feet()) {
    if (options.feet != 0 && options.feet != feet) continue;
    for (const GaitPattern& pattern : gait_library(feet)) {
      if (std::find(names.begin(), names.end(), pattern.name) == names.end())
        names.push_back(pattern.name);
      if (options.name == pattern.name) exact.push_back({feet, pattern});
      if (pattern.name.find(options.name) != std::string::npos) alike.push_back({feet, pattern});
    }
  }
  if (!exact.empty()) return exact;
  if (!alike.empty()) return alike;
  const std::string guess = nearest(options.name, names);
  throw InputError(fmt::format("gait '{}'{} is not in the library; {}there are {}", options.name,
                               options.feet == 0 ? "" : fmt::format(" for {} feet", options.feet),
                               guess.empty() ? "" : fmt::format("did you mean '{}'? ", guess),
                               fmt::join(names, ", ")));
}

std::vector<double> duties(const GaitPattern& pattern) {
  std::vector<double> values;
  for (std::size_t place = 0; place < pattern.touchdown.size(); ++place)
    values.push_back(pattern.duty_of(place));
  return values;
}

std::string duty_text(const GaitPattern& pattern) {
  if (pattern.foot_duty.empty()) return fmt::format("{:.3g}", pattern.duty);
  std::string text;
  for (double duty : pattern.foot_duty)
    text += fmt::format("{}{:.3g}", text.empty() ? "" : " ", duty);
  return text;
}

/// "FL+HR, FR+HL".
std::string order_text(const GaitPattern& pattern, const std::vector<std::string>& places) {
  std::string text;
  for (const std::vector<int>& together : touchdown_order(pattern)) {
    if (!text.empty()) text += ", ";
    for (std::size_t k = 0; k < together.size(); ++k)
      text += (k > 0 ? "+" : "") + places[static_cast<std::size_t>(together[k])];
  }
  return text;
}

std::string support_text(const SupportRange& range) {
  return range.least == range.most ? fmt::format("{}", range.least)
                                   : fmt::format("{} to {}", range.least, range.most);
}

/// A line per foot, # stance and . swing, and below it how many stand.
std::string diagram(const GaitPattern& pattern, const std::vector<std::string>& places) {
  std::vector<std::string> rows(places.size(), std::string(kColumns, '.'));
  std::string counts;
  for (int column = 0; column < kColumns; ++column) {
    int support = 0;
    for (std::size_t place = 0; place < places.size(); ++place) {
      if (!pattern.stands(place, static_cast<double>(column) / kColumns)) continue;
      rows[place][static_cast<std::size_t>(column)] = '#';
      ++support;
    }
    counts += fmt::format("{}", support);
  }
  std::string text;
  for (std::size_t place = 0; place < places.size(); ++place)
    text += fmt::format("  {:>4}  {}\n", places[place], rows[place]);
  return text + fmt::format("  {:>4}  {}\n", "feet", counts);
}

std::string gait_text(const Entry& entry) {
  const GaitPattern& pattern = entry.pattern;
  const std::vector<std::string> places = footfall_places(entry.foot_count);
  return fmt::format("{}: {}\n  duty {}; order {}; {} of {} feet on the ground\n{}", pattern.name,
                     pattern.about, duty_text(pattern), order_text(pattern, places),
                     support_text(support_range(pattern)), entry.foot_count,
                     diagram(pattern, places));
}

Json to_json(const std::vector<Entry>& entries) {
  Json gaits = Json::array();
  for (const auto& [foot_count, pattern] : entries) {
    const std::vector<std::string> places = footfall_places(foot_count);
    Json order = Json::array();
    for (const std::vector<int>& together : touchdown_order(pattern)) {
      Json beat = Json::array();
      for (int place : together) beat.push_back(places[static_cast<std::size_t>(place)]);
      order.push_back(beat);
    }
    const SupportRange range = support_range(pattern);
    gaits.push_back({{"feet", foot_count},
                     {"name", pattern.name},
                     {"about", pattern.about},
                     {"places", places},
                     {"duty", duties(pattern)},
                     {"touchdown", pattern.touchdown},
                     {"order", order},
                     {"support", {{"least", range.least}, {"most", range.most}}}});
  }
  return {{"schema", "legwright/gaits"}, {"version", 1}, {"gaits", gaits}};
}

std::string ruler() {
  return fmt::format("        {:<15}{:<15}{:<15}{:<11}{}\n", "0", "1/4", "1/2", "3/4", "cycle");
}

int gaits(const GaitsOptions& options) {
  const std::vector<Entry> entries = choose(options);
  if (options.json) {
    fmt::print("{}", to_text(to_json(entries)));
    return kOk;
  }
  int feet = 0;
  for (const Entry& entry : entries) {
    if (entry.foot_count != feet) {
      fmt::print("{}{} feet ({}); # on the ground, . in the air\n{}", feet == 0 ? "" : "\n",
                 entry.foot_count, fmt::join(footfall_places(entry.foot_count), ", "), ruler());
      feet = entry.foot_count;
    }
    fmt::print("\n{}", gait_text(entry));
  }
  fmt::print("\nIn a task file: [gait] name = \"{}\", or touchdown and duty of your own.\n",
             entries.front().pattern.name);
  return kOk;
}

}  // namespace

void add_gaits(CLI::App& program, Action& action) {
  const auto [verb, options] = add_verb(
      program, action, "gaits", "Draw the gaits of the library as footfall diagrams", gaits);
  verb->add_option("NAME", options->name, "one gait only, for instance trot");
  verb->add_option("--feet", options->feet, "of robots with so many feet only: 2 or 4 to 8")
      ->check(CLI::IsMember(gait_library_feet()));
  verb->add_flag("--json", options->json, "print one JSON document");
}

}  // namespace legwright
