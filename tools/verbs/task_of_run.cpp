// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/task_of_run.hpp"

#include <Eigen/Geometry>

#include "mjcf/text/input_error.hpp"
#include "optimizer/motion/path.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/checkpoint_file.hpp"
#include "tools/run/motion_csv.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

// What the plan itself reached in its cycle, against which the simulation is compared as well: the
// velocity of the COM along its arc. The plan holds what the root did; its COM goes along with it.
Eigen::Vector2d velocity_of(const Trajectory& plan) {
  const auto at_start = [&](int column) { return plan.at(0, column); };
  const Eigen::Vector2d com(at_start(plan.com_column(0)) - at_start(plan.root_column(0)),
                            at_start(plan.com_column(1)) - at_start(plan.root_column(1)));
  const Eigen::Vector2d step =
      Eigen::Vector2d(plan.travel[0], plan.travel[1]) + Eigen::Rotation2Dd(plan.turn) * com - com;
  return WantedPath::velocity_along_arc(step, plan.turn, plan.period);
}

/// The run around a design's folder, as that is written, where it can be gone on with; else empty.
fs::path stopped_search_around(const fs::path& folder) {
  constexpr int kDeepest = 5;  // RUN/tasks/NAME/iterations/0000
  fs::path at = folder.lexically_normal();
  for (int k = 0; k < kDeepest && !at.empty(); ++k, at = at.parent_path())
    if (has_checkpoint(at)) return at;
  return {};
}

}  // namespace

TaskOfRun task_of_run(const ResultFolder& folder) {
  const auto run = read_record_file<RunRecord>(folder.run_json());
  if (!run.task)
    throw InputError(folder.run_json().string(), 0, "task",
                     "expected the task of a run, as `legwright optimize` writes it; found none");
  const TaskRecord& task = *run.task;
  return {task.gait,
          {{task.velocity[0], task.velocity[1]}, task.turn_rate, task.facing()},
          task.step_over.value_or(0.0),
          run.stopped_early() ? std::optional(run.status) : std::nullopt};
}

SceneToValidate scene_to_validate(const fs::path& folder) {
  SceneToValidate out{folder / "scene.xml", Eigen::Vector2d::Zero()};
  if (!fs::is_regular_file(out.scene)) {
    const fs::path stopped = stopped_search_around(folder);
    throw IoError(out.scene.string() + ": no such file; " +
                  (!stopped.empty()
                       ? "the search was stopped before it was written: `legwright optimize "
                         "--resume " +
                             stopped.string() + "` goes on with it"
                       : "the run is not whole: run `legwright optimize` again, with --force"));
  }
  const Trajectory plan = read_motion_csv(folder / "motion.csv");
  out.plan_velocity = velocity_of(plan);
  out.joints = plan.joint_names;
  return out;
}

}  // namespace legwright
