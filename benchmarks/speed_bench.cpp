// SPDX-License-Identifier: Apache-2.0
// All figures of the speed table. Usage: speed_bench [--examples FOLDER] [--robots FOLDER]
// [--commit TEXT] [--markdown FILE] [GROUP ...] Groups: codesign cold iteration ipopt sqp gradient
// knots legs parameters tasks; all of them by default. JSON on stdout, with the tables under
// "markdown"; FILE gets the tables alone.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>

#include "benchmarks/figures.hpp"
#include "benchmarks/tables.hpp"
#include "benchmarks/timing.hpp"
#include "optimizer/factor/hessian_factor.hpp"

namespace legwright::bench {
namespace {

struct Options {
  std::filesystem::path examples = "examples";
  std::filesystem::path robots;  // ROBOTS/NAME/task.toml are timed, too; empty: none
  std::string commit = "unknown";
  std::string markdown;  // file, or empty
  std::vector<std::string> groups;

  bool wants(const std::string& group) const {
    return groups.empty() || std::find(groups.begin(), groups.end(), group) != groups.end();
  }
};

Options parse(int count, char** arguments) {
  Options options;
  for (int k = 1; k < count; ++k) {
    const std::string argument = arguments[k];
    if (argument == "--examples" && k + 1 < count)
      options.examples = arguments[++k];
    else if (argument == "--robots" && k + 1 < count)
      options.robots = arguments[++k];
    else if (argument == "--commit" && k + 1 < count)
      options.commit = arguments[++k];
    else if (argument == "--markdown" && k + 1 < count)
      options.markdown = arguments[++k];
    else
      options.groups.push_back(argument);
  }
  return options;
}

Json settings(const std::string& commit) {
  Json result = machine();
  result["flags"] = LEGWRIGHT_CXX_FLAGS;
  result["eigen"] = std::to_string(EIGEN_WORLD_VERSION) + "." +
                    std::to_string(EIGEN_MAJOR_VERSION) + "." + std::to_string(EIGEN_MINOR_VERSION);
  result["factor"] = factor_name();
  result["commit"] = commit;
  return result;
}

void run_case(const Options& options, bool first, SolvedCase& solved, Json& into,
              std::vector<Group>& groups) {
  const std::string& label = solved.of.label;
  const auto run = [&](const std::string& name, const std::function<Group()>& measure) {
    if (!options.wants(name) && name != "codesign") return;
    std::fprintf(stderr, "speed_bench: %s: %s\n", label.c_str(), name.c_str());
    Group group = measure();
    into[name] = group.details;
    if (options.wants(name)) groups.push_back(std::move(group));
  };
  run("codesign", [&] { return codesign_figures(solved); });
  run("cold", [&] { return cold_start_figures(solved); });
  run("iteration", [&] { return iteration_figures(solved); });
  if (solved.of.paper) {
    run("ipopt", [&] { return ipopt_figures(solved); });
    run("sqp", [&] { return sqp_figures(solved); });
    if (solved.problem.robot.morphology.foot_count() == 6)
      run("legs", [&] { return legs_figures(solved); });
  }
  if (!first) return;
  run("gradient", [&] { return gradient_figures(solved); });
  run("knots", [&] { return knots_figures(solved); });
  run("parameters", [&] { return parameters_figures(solved); });
  run("tasks", [&] { return tasks_figures(solved); });
}

int run(int count, char** arguments) {
  const Options options = parse(count, arguments);
  Json result;
  result["machine"] = settings(options.commit);
  std::vector<Group> groups;
  bool first = true;
  const std::vector<Case> all = cases(options.examples, options.robots);
  for (const Case& of : all) {
    SolvedCase solved{of, read_problem(of.task_file), {}, {}};
    run_case(options, first, solved, result["cases"][of.label], groups);
    first = false;
  }
  result["markdown"] = markdown(result, all, groups);
  std::puts(result.dump(2).c_str());
  if (options.markdown.empty()) return 0;
  std::ofstream file(options.markdown);
  for (const Json& line : result["markdown"]) file << line.get<std::string>() << '\n';
  return file.flush() ? 0 : 1;
}

}  // namespace
}  // namespace legwright::bench

int main(int count, char** arguments) {
  try {
    return legwright::bench::run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "speed_bench: %s\n", error.what());
    return 1;
  }
}
