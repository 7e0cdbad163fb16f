// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/motion/task.hpp"
#include "tools/task/task_keys.hpp"

namespace legwright {

/// Reads a task file strictly, with all its tasks. [style], [limits] and [weights] outside [[task]]
/// hold for every task that does not say otherwise. Throws as read_task_file().
/// @param robot instead of the file's, from the working directory; empty: the file's
TaskSet read_task_set(const std::filesystem::path& file, const std::filesystem::path& robot = {});
/// The same from text; `file` is for messages and to find the robot from.
TaskSet parse_task_set(const std::string& text, const std::filesystem::path& file,
                       const std::filesystem::path& robot = {});
/// The same without looking for the robot, which is as the text names it.
TaskSet parse_task_tables(const std::string& text, const std::filesystem::path& file);

/// Reads the file of one task strictly: TOML 1.0, known keys only, right types, finite and in
/// range. Throws InputError with one line for each thing that is wrong; also where the file or its
/// robot is missing, or where it holds several tasks.
TaskFile read_task_file(const std::filesystem::path& file);
/// The same from text; `file` is for messages and to find the robot from.
TaskFile parse_task_file(const std::string& text, const std::filesystem::path& file);

/// The task for this robot: gait pattern chosen, feet put in the robot's order, seconds turned into
/// knots. Throws InputError, with file and line of the key, where task and robot do not fit or the
/// speed is out of reach.
Task make_task(const TaskFile& file, const RobotModel& robot);

/// Knots planted on either side of stance: `seconds` in knots, at least one. Without a margin in
/// the task touchdown_error() of the leg's length (35 ms for legs of 21 cm) for gaits of duty ≤
/// 0.6, at most a sixth of the swing, else one knot. @param period of the cycle [s]
int planted_margin_knots(std::optional<double> seconds, double duty, double period,
                         double time_step, double leg_length);

/// How far the body travels while a foot stands, at most and as far as the robot could ever reach
/// [m].
struct StrideBound {
  double per_cycle = 0.0;   // of the body, per period
  double per_stance = 0.0;  // of the body while one foot stands
  double longest = 0.0;     // twice the longest leg that the bounds of s allow
  double leg_length = 0.0;  // longest leg at the initial design
};
StrideBound stride_bound(const Task& task, const RobotModel& robot);

/// What looks doubtful but is allowed, one sentence each.
std::vector<std::string> task_warnings(const Task& task, const RobotModel& robot);

/// Centres of the feet in the frame of the trunk, home pose, design s [m].
std::vector<Eigen::Vector3d> home_feet(const Morphology& morphology, const Eigen::VectorXd& s);
std::vector<std::string> foot_names(const Morphology& morphology);

}  // namespace legwright
