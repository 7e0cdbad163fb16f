// SPDX-License-Identifier: Apache-2.0
#include "tools/task/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "mjcf/read/servos.hpp"
#include "mjcf/scene/surroundings.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/refusals.hpp"
#include "optimizer/terms/registry.hpp"
#include "tools/task/design_table.hpp"
#include "tools/task/facing_warnings.hpp"
#include "tools/task/toml_reader.hpp"

namespace legwright {
namespace {

Objective make_objective(const TaskFile& file, const RobotModel& robot, const Task& task) {
  try {
    return {as_in_task(robot.morphology, task), robot.space, task};
  } catch (const std::invalid_argument& error) {
    throw InputError(file.file.string(), 0, "",
                     std::string(error.what()) + "; robot and task do not fit");
  }
}

[[noreturn]] void refuse_outer(const TaskSet& set, const std::string& why) {
  const auto line = set.lines.find("outer.objective");
  throw InputError(set.file.string(), line == set.lines.end() ? 0 : line->second, "outer.objective",
                   why);
}

/// The same task with the quantity of J in the place of F: one term, all others off.
Task outer_task(const TaskSet& set, Task task) {
  std::vector<std::string> names;
  for (const TermEntry& entry : term_registry()) {
    task.weights[std::string(entry.name)] = 0.0;
    if (entry.role == TermRole::outer) names.emplace_back(entry.name);
  }
  if (std::find(names.begin(), names.end(), set.outer) == names.end())
    refuse_outer(set, fmt::format("'{}' is no outer objective; there are {}", set.outer,
                                  fmt::join(names, ", ")));
  task.weights[set.outer] = 1.0;
  return task;
}

/// J, with the servos' gains as they are played.
std::unique_ptr<OuterObjective> make_outer(const TaskSet& set, const TaskFile& file,
                                           const RobotModel& robot, const Task& task) {
  RobotModel played = with_task_servos(robot, task);
  set_gains(played.servos, robot.space.initial(), played.morphology);
  try {
    return std::make_unique<OuterTerm>(make_objective(file, played, outer_task(set, task)),
                                       set.outer, set.outer_weight);
  } catch (const std::invalid_argument& error) {
    refuse_outer(set, std::string(error.what()) + "; take out [outer], or choose another");
  }
}

}  // namespace

std::string CodesignProblem::speed_unit(int k) const {
  return objectives[k]->task().velocity.norm() == 0.0 ? "rad/s" : "m/s";
}

CodesignProblem read_problem(const std::filesystem::path& task_file,
                             const std::filesystem::path& robot, const FileReach& reach) {
  TaskSet set = read_task_set(task_file, robot);
  RobotModel model = read_robot(set.robot, reach);
  return make_problem(std::move(set), std::move(model));
}

CodesignProblem make_problem(TaskSet set, RobotModel robot) {
  CodesignProblem problem;
  problem.set = std::move(set);
  problem.robot = std::move(robot);
  // What the file names that the robot does not have is told in one list.
  Refusals reasons;
  reasons.collect([&] {
    problem.robot.space = restricted(problem.robot.space, problem.set.design,
                                     problem.set.file.string(), problem.set.lines);
  });
  std::vector<Task> tasks;
  for (const TaskFile& file : problem.set.tasks)
    reasons.collect([&] { tasks.push_back(make_task(file, problem.robot)); });
  reasons.throw_if_any();
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const TaskFile& file = problem.set.tasks[k];
    const Task& task = tasks[k];
    problem.objectives.push_back(
        std::make_unique<Objective>(make_objective(file, problem.robot, task)));
    if (!problem.set.outer.empty())
      problem.outers.push_back(make_outer(problem.set, file, problem.robot, task));
  }
  return problem;
}

std::vector<std::string> warnings_on(const CodesignProblem& problem, int task) {
  const Task& asked = problem.objectives[static_cast<std::size_t>(task)]->task();
  std::vector<std::string> out = task_warnings(asked, problem.robot);
  for (std::string& warning : facing_warnings(problem.task(task), problem.robot))
    out.push_back(std::move(warning));
  return out;
}

void set_outer(CodesignProblem& problem, const OwnOuter& own) {
  TaskSet& set = problem.set;
  if (!set.outer.empty())
    refuse_outer(set, fmt::format("the task asks for '{}', and an objective was given, too; take "
                                  "out [outer], or do without the other",
                                  set.outer));
  set.outer = own.name;
  set.outer_source = own.source;
  set.outer_weight = own.weight;
  for (int k = 0; k < problem.task_count(); ++k) {
    try {
      problem.outers.push_back(std::make_unique<OuterFunction>(
          *problem.objectives[k], own.functions(k), own.unit, own.weight, own.reference));
    } catch (const std::invalid_argument& error) {
      throw InputError(
          set.file.string(), 0, "objective",
          fmt::format("{}: {}; give reference a positive amount", own.name, error.what()));
    }
  }
}

ProblemCosts::ProblemCosts(const CodesignProblem& problem, const FirstMotionOptions& first) {
  for (int k = 0; k < problem.task_count(); ++k) {
    const Objective& objective = *problem.objectives[k];
    JointTask task;
    task.name = problem.task(k).name;
    task.weight = problem.task(k).weight;
    task.cost = costs_.emplace_back(std::make_unique<ObjectiveCost>(objective)).get();
    if (!problem.outers.empty())
      task.outer = costs_.emplace_back(problem.outers[k]->make_cost()).get();
    const auto guesses = std::make_shared<int>(0);  // of this task: the names of their checkpoints
    task.guess = [&objective, first, k, guesses](const Eigen::VectorXd& s) {
      FirstMotionOptions own = first;
      own.checkpoint = own.checkpoint.in(k).in((*guesses)++);
      return best_first_motion(objective, s, own);
    };
    tasks_.push_back(std::move(task));
  }
}

}  // namespace legwright
