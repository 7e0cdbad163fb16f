// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/motion/task.hpp"
#include "tools/files/json_file.hpp"
#include "tools/task/problem.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {

/// All that `check` finds of a task and its robot; both outputs are made from it.
struct CheckedTask {
  TaskFile file;
  RobotModel robot;
  Task task;
  StrideBound stride;
  std::vector<std::string> warnings;
  std::string outer;  // line about the outer objective, or empty
};

/// One for each task of a problem.
std::vector<CheckedTask> checked_tasks(const CodesignProblem& problem);

/// What `check` prints of them, but for its last line. @param all at least one
std::string to_text(const std::vector<CheckedTask>& all);
/// The document of `check --json`; of several tasks it has that of each by its name.
Json to_json(const std::vector<CheckedTask>& all);

}  // namespace legwright
