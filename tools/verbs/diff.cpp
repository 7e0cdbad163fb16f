// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <numeric>

#include "mjcf/read/checks.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/robot_files.hpp"
#include "mjcf/write/model_diff.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/json_file.hpp"
#include "tools/verbs/diff_pictures.hpp"
#include "tools/verbs/number_options.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

struct DiffOptions : ReadingOptions {
  std::string before, after, shown;
  double tolerance = 1e-9;
  int pixels = 0;
  bool json = false;
};

bool is_picture(const std::string& file) { return file.ends_with(".png"); }

ModelPointer compiled(const std::string& file, const FileReach& reach) {
  const RobotFiles files = RobotFiles::read(file, reach);
  return files.at_their_lines([&] {
    check_values(*load_xml(files.text(), files.file()));
    return compile_mjcf(files.text(), files.file(), MeshDetail::triangles);
  });
}

double mass_of(const mjModel& model) {
  return std::accumulate(model.body_mass, model.body_mass + model.nbody, 0.0);
}

/// What differs, without the rounding errors.
struct Found {
  std::vector<Difference> differences;
  std::size_t passed_over = 0;
};

Found compare(const mjModel& a, const mjModel& b, double tolerance) {
  Found out;
  out.differences = model_differences(a, b, 0.0);
  out.passed_over = std::erase_if(out.differences, [&](const Difference& difference) {
    return is_dust(difference, tolerance);
  });
  return out;
}

/// @param noise numbers no larger are rounding errors beside the others, and told as 0
std::string numbers(const std::vector<double>& values, int digits, double noise) {
  std::string text;
  for (const double value : values)
    text += fmt::format("{}{:.{}g}", text.empty() ? "" : " ",
                        std::abs(value) <= noise ? 0.0 : value, digits);
  return text;
}

/// "0.1 0 0 -> 0.2 0 0", with more digits where six would tell the same twice.
std::string before_and_after(const Difference& d, double tolerance) {
  double largest = 0.0;
  for (const std::vector<double>* values : {&d.before, &d.after})
    for (const double value : *values) largest = std::max(largest, std::abs(value));
  std::string before, after;
  for (const int digits : {6, 12, 17}) {
    before = numbers(d.before, digits, tolerance * largest);
    after = numbers(d.after, digits, tolerance * largest);
    if (before != after) break;
  }
  return before + " -> " + after;
}

Json to_json(const DiffOptions& options, const mjModel& a, const mjModel& b, const Found& found) {
  Json list = Json::array();
  for (const Difference& d : found.differences)
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
          {"differences", list},
          {"passed_over", found.passed_over}};
}

/// 0 where nothing differs, 1 where something does, as `diff` has it.
int diff(const DiffOptions& options) {
  if (is_picture(options.before) || is_picture(options.after))
    return diff_pictures(
        {options.before, options.after, options.pixels, options.shown, options.json});
  const ModelPointer a = compiled(options.before, options.reach()),
                     b = compiled(options.after, options.reach());
  const Found found = compare(*a, *b, options.tolerance);
  const bool same = found.differences.empty();
  if (options.json) {
    fmt::print("{}", to_text(to_json(options, *a, *b, found)));
    return same ? kOk : kInfeasible;
  }
  std::string element;
  for (const Difference& d : found.differences) {
    if (d.element != element) fmt::print("{}\n", clean_utf8(d.element));
    element = d.element;
    if (d.whole())
      fmt::print("  {}\n", clean_utf8(d.quantity));
    else if (d.before.size() == 4 || d.quantity == "axis")
      fmt::print("  {:18} turned by {:.6g} {}{}\n", d.quantity, d.size, d.unit,
                 d.before.size() == 4 ? "" : ": " + before_and_after(d, options.tolerance));
    else
      fmt::print("  {:18} {} {}\n", d.quantity, before_and_after(d, options.tolerance), d.unit);
  }
  fmt::print("{} differences; mass {:.6g} -> {:.6g} kg\n", found.differences.size(), mass_of(*a),
             mass_of(*b));
  if (found.passed_over > 0)
    fmt::print("{} more below {:g} of their quantity passed over (--tolerance 0 lists them)\n",
               found.passed_over, options.tolerance);
  return same ? kOk : kInfeasible;
}

}  // namespace

void add_diff(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "diff",
               "What differs between two models, in metres, radians and kilograms, or between two "
               "pictures",
               diff);
  verb->add_option("A", options->before, "MJCF file, or PNG")->required();
  verb->add_option("B", options->after, "MJCF file, or PNG")->required();
  verb->add_option("--tolerance", options->tolerance,
                   "share of a quantity up to which differences are none (of 1 m, rad, kg … where "
                   "it is less)")
      ->check(number_from_zero())
      ->capture_default_str();
  verb->add_option("--pixels", options->pixels, "pictures: how many pixels may differ")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  verb->add_option(
      "-o,--output", options->shown,
      "pictures: where before, after and difference go, side by side, if more do; an old one "
      "goes away if not");
  verb->add_flag("--json", options->json, "print one JSON document");
  verb->footer(
      "Both files are compiled by MuJoCo and compared element by element, by name: bodies, joints, "
      "geoms, sites, tendons,\n"
      "actuators, keyframes and declared design parameters; not materials, assets and options.\n"
      "Pictures, as `legwright render` draws them, are compared pixel by pixel: the same renderer "
      "draws "
      "the same bytes.\n"
      "Exit code: 0 nothing differs, 1 something does, 2 a file is no model or no picture.");
}

}  // namespace legwright
