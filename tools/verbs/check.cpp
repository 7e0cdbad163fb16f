// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "mjcf/text/input_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/files/shell_word.hpp"
#include "tools/task/problem.hpp"
#include "tools/verbs/check_keys.hpp"
#include "tools/verbs/checked_task.hpp"
#include "tools/verbs/gradients.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

struct CheckOptions : ReadingOptions {
  std::string task, robot;
  bool json = false, gradients = false, keys = false;
};

int check_all_gradients(const CheckOptions& options) {
  const std::vector<GradientCheck> checks =
      check_gradients(read_problem(options.task, options.robot, options.reach()));
  if (options.json)
    fmt::print("{}", to_text(Json{{"schema", "legwright/gradients"},
                                  {"version", 1},
                                  {"tolerance", kGradientTolerance},
                                  {"checks", to_json(checks)}}));
  else
    fmt::print("{}", to_text(checks));
  const bool good = std::all_of(checks.begin(), checks.end(), passes);
  return good ? kOk : kInternal;
}

int check(const CheckOptions& options) {
  if (options.keys) {
    fmt::print("{}", options.json ? to_text(keys_json()) : keys_text());
    return kOk;
  }
  if (options.task.empty())
    throw InputError("TASK is required: `legwright check TASK`; --keys tells what it may say");
  if (options.gradients) return check_all_gradients(options);
  const std::vector<CheckedTask> all = checked_tasks(
      read_problem(options.task, options.robot, options.reach()));  // as optimize refuses
  if (options.json) {
    fmt::print("{}", to_text(to_json(all)));
    return kOk;
  }
  fmt::print("{}", to_text(all));
  fmt::print("ok      next: legwright optimize {}{}\n", shell_word(options.task),
             options.robot.empty() ? "" : " --robot " + shell_word(options.robot));
  return kOk;
}

}  // namespace

void add_check(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "check",
               "Read a task and its robot; explain them, or refuse with a reason", check);
  CLI::Option* const task =
      verb->add_option("TASK", options->task, "task file (TOML), which names its robot");
  verb->add_option("--robot", options->robot, "MJCF of another robot than the one the task names");
  verb->add_flag(
      "--gradients", options->gradients,
      "check all derivatives of F, and the adjoint, against central differences instead");
  verb->add_flag(
          "--keys", options->keys,
          "without a task: tell every key of a task file, its type, unit, bounds and default")
      ->excludes(task);
  verb->add_flag("--json", options->json, "print one JSON document");
}

}  // namespace legwright
