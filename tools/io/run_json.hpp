// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mjcf/read_robot.hpp"
#include "optimizer/objective/objective.hpp"
#include "optimizer/solve/codesign.hpp"
#include "tools/io/design_folder.hpp"
#include "tools/io/json_file.hpp"
#include "tools/io/task_file.hpp"

namespace legwright {

/// What is known when a run starts: schema legwright/run, status "running", versions, inputs with
/// their SHA-256, task, sizes, parameters.
Json start_of_run(const std::vector<std::string>& argv, const TaskFile& file,
                  const RobotModel& robot, const Objective& objective);

/// Fills in how it ended. @param status "converged", "stalled", … or "interrupted"
/// @param history F of each iteration from 0 on @param reasons why the result is infeasible; empty:
/// it is not
void finish_run(Json& run, const std::string& status, const CodesignResult& result,
                const PlanQuality& quality, const std::vector<double>& history, double file_seconds,
                const std::vector<std::string>& reasons, const DesignSpace& space);

/// The event of an iteration for events.jsonl.
Json iteration_event(const DesignSpace& space, const DesignIteration& iteration,
                     const PlanQuality& quality);

}  // namespace legwright
