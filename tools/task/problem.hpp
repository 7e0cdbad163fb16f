// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/first_motion.hpp"
#include "optimizer/solve/multistart.hpp"
#include "optimizer/solve/outer_cost.hpp"
#include "optimizer/solve/outer_function.hpp"
#include "tools/task/task_file.hpp"

namespace legwright {

/// A robot and all that it shall do, ready to be solved.
struct CodesignProblem {
  TaskSet set;
  RobotModel robot;
  std::vector<std::unique_ptr<Objective>> objectives;   // F of each task, in the file's order
  std::vector<std::unique_ptr<OuterObjective>> outers;  // J of each task; empty without one

  const TaskFile& task(int k) const { return set.tasks[k]; }
  int task_count() const { return static_cast<int>(objectives.size()); }
  /// What "speed" means for a task: m/s, or rad/s where it only turns.
  std::string speed_unit(int k) const;
};

/// Reads a task file and its robot and builds F of each task. Throws InputError with everything
/// that is wrong. @param robot instead of the one that the task file names
/// @param reach of the files that the robot names
CodesignProblem read_problem(const std::filesystem::path& task_file,
                             const std::filesystem::path& robot = {}, const FileReach& reach = {});
/// The same of what is read already. Throws InputError where tasks and robot do not fit.
CodesignProblem make_problem(TaskSet set, RobotModel robot);

/// What `check` and `optimize` warn of in one of its tasks: task_warnings(), facing_warnings().
std::vector<std::string> warnings_on(const CodesignProblem& problem, int task);

/// An outer objective that is no term of the registry.
struct OwnOuter {
  std::string name;
  std::string source;  // where it comes from, for the record of the run
  std::string unit;
  double weight = 1.0;
  std::optional<double> reference;                    // v₀; none: v of each task's first guess
  std::function<MotionQuantity(int task)> functions;  // v, by task
};

/// Makes it the problem's J. Throws InputError where the task file has one, too, or its reference
/// is not positive.
void set_outer(CodesignProblem& problem, const OwnOuter& own);

/// The costs of a problem, as the solvers want them. Keeps references to the problem.
class ProblemCosts {
 public:
  /// @param first how the first motion of a body is found
  explicit ProblemCosts(const CodesignProblem& problem, const FirstMotionOptions& first = {});
  const std::vector<JointTask>& tasks() const { return tasks_; }

 private:
  std::vector<std::unique_ptr<CostFunction>> costs_;
  std::vector<JointTask> tasks_;
};

}  // namespace legwright
