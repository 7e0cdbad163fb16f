// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "optimizer/solve/multistart.hpp"
#include "tools/run/design_folder.hpp"
#include "tools/run/iteration_record.hpp"
#include "tools/run/run_record.hpp"
#include "tools/task/problem.hpp"

namespace legwright {

/// What is known when a run starts: status "running", versions, inputs with their SHA-256, sizes,
/// parameters; and one task of the problem.
RunRecord start_of_run(const std::vector<std::string>& argv, const CodesignProblem& problem,
                       int task);
/// The same for all tasks of a problem: "tasks" in the place of "task".
RunRecord start_of_joint_run(const std::vector<std::string>& argv, const CodesignProblem& problem);

/// Mass and printed volume of the robot at a design.
BodyRecord body_record(const RobotModel& robot, const Eigen::VectorXd& s);

/// What it took to get there.
struct RunEffort {
  int design_iterations = 0, newton_iterations = 0, factorisations = 0;
  CodesignSeconds seconds;
  double file_seconds = 0.0;
};
RunEffort effort_of(const CodesignResult& result);
/// Sum over all runs of all starts.
RunEffort effort_of(const MultistartResult& result);

/// How one task fared: from the body as it is, to the design that was found.
struct TaskOutcome {
  int task = 0;  // of the iterations below
  const DesignIteration* initial = nullptr;
  const DesignIteration* best = nullptr;
  std::vector<double> motion_only_trace;  // F by Newton step at the initial design
  std::vector<double> history;            // F of the task by iteration, from 0 on
  PlanQuality quality;                    // of the result
  std::vector<std::string> reasons;       // why the result is infeasible; empty: it is not
};

/// Fills in how a run of one task ended. @param status "converged", "stalled", … or "interrupted"
void finish_run(RunRecord& run, const std::string& status, const TaskOutcome& outcome,
                const RunEffort& effort, const RobotModel& robot);
/// Fills in how a joint run ended: the winner, and every start beside it.
void finish_joint_run(RunRecord& run, const std::string& status, const MultistartResult& result,
                      const std::vector<TaskOutcome>& outcomes, const RunEffort& effort,
                      const CodesignProblem& problem);

/// Every start of a run that had several: F at the start and at the end, and which was best.
void add_starts(RunRecord& run, const MultistartResult& result, const CodesignProblem& problem);

/// The last event of a run that has ended.
EndEvent end_event(const RunRecord& run);
/// The event of one task at an iteration for events.jsonl.
IterationEvent iteration_event(const DesignSpace& space, const DesignIteration& iteration, int task,
                               const PlanQuality& quality);
/// The event of an iteration of all tasks of a run. @param qualities of the run's tasks, in order
JointIterationEvent joint_iteration_event(const CodesignProblem& problem, const RunLabel& label,
                                          const DesignIteration& iteration,
                                          const std::vector<PlanQuality>& qualities);

}  // namespace legwright
