// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <numeric>

#include "mjcf/checks.hpp"
#include "mjcf/compile.hpp"
#include "mjcf/model_diff.hpp"
#include "mjcf/robot_files.hpp"
#include "tools/io/clean_text.hpp"
#include "tools/io/json_file.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

struct DiffOptions {
  std::string before, after;
  double tolerance = 1e-9;
  bool json = false;
};

ModelPointer compiled(const std::string& file) {
  const RobotFiles files = RobotFiles::read(file);
  return files.at_their_lines([&] {
    check_values(*load_xml(files.text(), files.file()));
    return compile_mjcf(files.text(), files.file());
  });
}

double mass_of(const mjModel& model) {
  return std::accumulate(model.body_mass, model.body_mass + model.nbody, 0.0);
}

std::string numbers(const std::vector<double>& values) {
  std::string text;
  for (const double value : values)
    text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", value == 0.0 ? 0.0 : value);
  return text;
}

Json to_json(const DiffOptions& options, const mjModel& a, const mjModel& b,
             const std::vector<Difference>& found) {
  Json list = Json::array();
  for (const Difference& d : found)
    list.push_back({{"element", d.element},
                    {"quantity", d.quantity},
                    {"unit", d.unit},
                    {"before", d.before},
                    {"after", d.after},
                    {"size", d.size}});
  return {{"schema", "legwright/diff"},
          {"version", 1},
          {"before", options.before},
          {"after", options.after},
          {"mass_kg", {{"before", mass_of(a)}, {"after", mass_of(b)}}},
          {"differences", list}};
}

/// 0 where nothing differs, 1 where something does, as `diff` has it.
int diff(const DiffOptions& options) {
  const ModelPointer a = compiled(options.before), b = compiled(options.after);
  const std::vector<Difference> found = model_differences(*a, *b, options.tolerance);
  if (options.json) {
    fmt::print("{}", to_text(to_json(options, *a, *b, found)));
    return found.empty() ? kOk : kInfeasible;
  }
  std::string element;
  for (const Difference& d : found) {
    if (d.element != element) fmt::print("{}\n", clean_utf8(d.element));
    element = d.element;
    if (d.whole())
      fmt::print("  {}\n", clean_utf8(d.quantity));
    else if (d.before.size() == 4 || d.quantity == "axis")
      fmt::print("  {:18} turned by {:.6g} {}{}\n", d.quantity, d.size, d.unit,
                 d.before.size() == 4
                     ? ""
                     : fmt::format(": {} -> {}", numbers(d.before), numbers(d.after)));
    else
      fmt::print("  {:18} {} -> {} {}\n", d.quantity, numbers(d.before), numbers(d.after), d.unit);
  }
  fmt::print("{} differences; mass {:.6g} -> {:.6g} kg\n", found.size(), mass_of(*a), mass_of(*b));
  return found.empty() ? kOk : kInfeasible;
}

}  // namespace

void add_diff(CLI::App& program, Action& action) {
  const auto options = std::make_shared<DiffOptions>();
  CLI::App* verb = program.add_subcommand(
      "diff", "What differs between two models, in metres, radians and kilograms");
  verb->add_option("A", options->before, "MJCF file")->required();
  verb->add_option("B", options->after, "MJCF file")->required();
  verb->add_option("--tolerance", options->tolerance, "differences up to it are none")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb->add_flag("--json", options->json, "print one JSON document");
  verb->footer(
      "Both files are compiled by MuJoCo and compared element by element, by name: bodies, joints, "
      "geoms, sites, tendons,\n"
      "actuators, keyframes and declared design parameters; not materials, assets and options.\n"
      "Exit code: 0 nothing differs, 1 something does, 2 a file is no model.");
  verb->callback([&action, options] { action = [options] { return diff(*options); }; });
}

}  // namespace legwright
