// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "tools/io/result_folder.hpp"
#include "tools/verbs/judge_run.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

struct Options {
  std::string run;
  ValidationOptions validation;
  bool json = false;
};

void print_verdicts(const JudgedRun& judged, const Json& run, const std::string& indent) {
  const bool same = run.value("motion_only", false);
  fmt::print("{0}initial design:     {1}\n{0}{2}  {3}\n", indent, judged.designs[0].verdict.line,
             same ? "the same, as result:" : "co-designed robot:", judged.designs[1].verdict.line);
}

/// One line per design, one column per task: F, and what physics says.
void print_matrix(const Json& matrix) {
  fmt::print("{:24}", "F and verdict of");
  for (const auto& [task, cells] : matrix["cells"].items()) fmt::print("{:>20}", task);
  for (std::size_t k = 0; k < matrix["designs"].size(); ++k) {
    fmt::print("\n  body {:17}", matrix["designs"][k]["name"].get<std::string>());
    for (const auto& [task, cells] : matrix["cells"].items())
      fmt::print("{:>13.4g} {:>6}", cells[k]["F"].get<double>(),
                 cells[k]["pass"].get<bool>() ? "PASS" : "FAIL");
  }
  fmt::print("\n");
}

int validate_joint(const ResultFolder& folder, const Json& run, const Options& options) {
  std::vector<JudgedRun> judged;
  const Json matrix = judge_joint_run(folder, run, options.validation, judged);
  if (options.json) {
    fmt::print("{}", to_text(matrix));
  } else {
    for (std::size_t k = 0; k < judged.size(); ++k) {
      fmt::print("{}\n", run["tasks"][k]["name"].get<std::string>());
      print_verdicts(judged[k], run, "  ");
    }
    print_matrix(matrix);
  }
  return matrix["pass"].get<bool>() ? kOk : kInfeasible;
}

int validate(const Options& options) {
  const ResultFolder folder = ResultFolder::open(options.run);
  const Json run = read_json(folder.run_json());
  if (run.contains("tasks")) return validate_joint(folder, run, options);
  const JudgedRun judged = judge_run(folder, {}, options.validation);
  if (options.json)
    fmt::print("{}", to_text({{"verdict", judged.verdict}, {"metrics", judged.metrics}}));
  else
    print_verdicts(judged, run, "");
  return judged.designs[1].verdict.pass ? kOk : kInfeasible;
}

}  // namespace

void add_validate(CLI::App& program, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb =
      program.add_subcommand("validate", "Play the gaits of a run in MuJoCo and judge them");
  verb->add_option("run", options->run, "Folder that legwright optimize wrote")->required();
  verb->add_option("--cycles", options->validation.cycles, "Cycles of the gait to play")
      ->check(CLI::Range(4, 10000))
      ->capture_default_str();
  verb->add_option("--threads", options->validation.threads,
                   "Roll-outs at the same time; results do not depend on it")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  verb->add_flag("--json", options->json, "One JSON document on stdout: verdict and metrics");
  verb->footer(
      "Plays iterations/0000/scene.xml (the initial design) and result/scene.xml, each at half, "
      "default and double\n"
      "servo gains, headless. Passes when the result never falls, keeps 95 to 105 % of the planned "
      "speed along its\n"
      "heading, tilts by less than 0.1 rad, saturates no servo and MuJoCo has nothing to warn of, "
      "at all gains.\n"
      "Writes metrics.json, verdict.json, playback_initial.csv and playback_result.csv into "
      "result/.\n"
      "Exit code: 0 the result passes, 1 it fails, 2 bad input, 3 a file cannot be read or "
      "written.");
  verb->callback([options, &action] { action = [options] { return validate(*options); }; });
}

}  // namespace legwright
