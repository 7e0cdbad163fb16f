// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "optimizer/solve/checkpoint.hpp"
#include "tools/choose/candidate.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_record.hpp"
#include "tools/task/problem.hpp"
#include "tools/validate/physics_steps.hpp"

namespace legwright {

/// A scalar of a task that `--physics-steps` may change, beside the body that stays as it is.
struct GaitScalar {
  std::string name;    // "speed": a factor on [travel] velocity
  double unit;         // relative change that counts as one
  double least, most;  // bounds of the factor
};

/// Those that mean something for a task: a factor on the wanted speed, turn rate, swing height and
/// period, and on the margins that the plan keeps from its friction cone and its least normal
/// force. The margins may only grow: a plan on the edge would play a little better and stand a lot
/// less.
std::vector<GaitScalar> gait_scalars(const TaskFile& task);

/// The task file with its scalars multiplied. @param factors in the order of gait_scalars()
TaskFile scaled_task(const TaskFile& task, const std::vector<GaitScalar>& scalars,
                     const Eigen::VectorXd& factors);

struct CloseGapOptions {
  int steps = 0;
  int threads = 1;
  std::function<void(const std::string&)> tell = {};  // one line per step
  std::function<bool()> stop = {};
  Checkpoint checkpoint = {};  // of the gaits that were played
};

/// `optimize --physics-steps N` of one task: plans the gait anew, on the same body, with other
/// scalars, plays it in MuJoCo at half, default and double gains, and keeps what is confirmed to be
/// closer to the task than before. Replaces the task's result/ where there is something better.
/// @param chosen the design of the run, with what its search tightened. @param k of the problem's
/// tasks
/// @return what run.json says of it: schema in tools/README.md
PhysicsStepsRecord close_gap(const ResultFolder& folder, const CodesignProblem& problem,
                             const Candidate& chosen, int k, const CloseGapOptions& options);

}  // namespace legwright
