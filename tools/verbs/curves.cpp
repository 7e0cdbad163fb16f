// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/report/curves.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

struct CurvesOptions {
  std::vector<std::string> runs, variants;
  std::string page = "curves.html", picture;
  bool json = false;
};

/// NAME=RUN,RUN
NamedRuns named_runs(const std::string& words) {
  const std::size_t equals = words.find('=');
  NamedRuns named{words.substr(0, equals), {}};
  for (std::size_t from = equals; from < words.size();) {
    const std::size_t comma = std::min(words.find(',', from + 1), words.size());
    if (comma > from + 1) named.runs.emplace_back(words.substr(from + 1, comma - from - 1));
    from = comma;
  }
  if (equals == std::string::npos || named.name.empty() || named.runs.empty())
    throw InputError("--variant " + words +
                     ": expected NAME=RUN,RUN, for example --variant 'stiff=runs/a,runs/b'");
  return named;
}

/// A line for each run, for a terminal.
void print_table(const Curves& curves) {
  for (const CurveVariant& variant : curves.variants) {
    fmt::print("{}\n", variant.name);
    for (const CurvePoint& point : variant.points) {
      const CurveSample& usual = point.at_default();
      fmt::print("  {:>5.3g} m/s  {}  {:>5}  limbs touch {:>3.0f} % of the time  F {:.4g}\n",
                 point.wanted, point.pass ? "PASS" : "FAIL",
                 usual.speed_ratio ? fmt::format("{:.0f} %", 100.0 * *usual.speed_ratio) : "falls",
                 100.0 * usual.touch_share, point.cost);
    }
  }
}

int curves(const CurvesOptions& options) {
  std::vector<NamedRuns> named;
  for (const std::string& words : options.variants) named.push_back(named_runs(words));
  const Curves found = read_curves({options.runs.begin(), options.runs.end()}, named);
  if (found.variants.empty())
    throw InputError(
        "no runs to draw: name folders that `legwright optimize` wrote and `legwright "
        "validate` judged");
  write_file(options.page, curves_page(found));
  if (!options.picture.empty()) write_file(options.picture, curves_picture(found));
  if (options.json) {
    Json document = curves_json(found);
    document["page"] = options.page;
    fmt::print("{}", to_text(document));
  } else {
    print_table(found);
    fmt::print("{}\n", options.page);
  }
  return kOk;
}

}  // namespace

void add_curves(CLI::App& program, Action& action) {
  const auto [verb, options] = add_verb(
      program, action, "curves",
      "Draw validated runs of one robot against their wanted speeds: one HTML file", curves);
  verb->add_option("run", options->runs,
                   "Folders that legwright optimize wrote, one for each speed and variant");
  verb->add_option("--variant", options->variants,
                   "NAME=RUN,RUN: runs under a name of their own; may be given again")
      ->allow_extra_args(false);
  verb->add_option("-o,--output", options->page, "The page to write")->capture_default_str();
  verb->add_option("--picture", options->picture,
                   "Also the chart of F alone, as an SVG file of its own");
  verb->add_flag("--json", options->json, "One JSON document on stdout: what was drawn");
  verb->footer(
      "Groups the runs by what they are: co-designed, motion only, and the terms of F that their "
      "task sets to zero.\n"
      "Draws measured speed, touches of limbs, tilt, servos at their limit, F and the main design "
      "parameters, with a\n"
      "table under it. Runs must be of one robot, one gait and one direction, and validated.\n"
      "examples/curves makes such a set.");
}

}  // namespace legwright
