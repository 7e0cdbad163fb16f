// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mjcf/read/read_robot.hpp"
#include "optimizer/motion/task.hpp"

namespace legwright {

/// A task file as it was written: everything that can be known without the robot. SI units. Keys
/// that are absent in the file have the defaults that stand here.
struct TaskFile {
  std::filesystem::path file;
  std::string text;  // byte for byte
  std::string name;  // of the file, without its extension, unless the file says otherwise
  std::filesystem::path robot;  // found from the folder of the task file

  std::string gait;               // of the library, or a name for a pattern of one's own
  std::optional<double> duty;     // of all feet, or
  std::vector<double> foot_duty;  // in footfall order, or
  std::map<std::string, double> duty_by_foot;       // by the foot's name; none: the library's
  std::vector<double> touchdown;                    // in footfall order, or
  std::map<std::string, double> touchdown_by_foot;  // by the foot's name
  double period = 0.0;
  int knots = 24;

  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
  double turn_rate = 0.0;
  double slope_along = 0.0,
         slope_across = 0.0;  // the ground rises on the way, to the left of it [rad]

  std::optional<double> com_height;       // or
  std::vector<double> com_heights;        // over the cycle
  std::vector<Eigen::Vector2d> com_path;  // off the wanted path, over the cycle
  std::map<std::string, std::vector<Eigen::Vector2d>>
      foot_targets;  // by the foot's name, over the cycle
  std::vector<Eigen::Vector2d>
      footprint;  // in footfall order; one entry: half length and half width
  Task margins;  // friction … limb_pairs, payload, torque_limit and step_over over Task's defaults
  std::optional<double> planted_margin;  // [s]
  std::map<std::string, double> weights;

  double weight = 1.0;  // w of F_joint = Σ w F; 1 where the file holds one task

  std::map<std::string, int> lines;  // of each key that is there, by its path: "gait.period"
  int line(const std::string& key) const;
  /// Throws InputError with file and line of the key.
  [[noreturn]] void refuse(const std::string& key, const std::string& message) const;
};

/// What a task file says about s: [design] freeze = ["body_width"] and [design.bounds]
/// body_length = [0.2, 0.3].
struct DesignTable {
  std::vector<std::string> freeze;                    // stay at their initial value
  std::map<std::string, std::vector<double>> bounds;  // lower, upper, within those of the robot
};

/// Everything that a task file asks of one body: one task, or several under [[task]].
struct TaskSet {
  std::filesystem::path file;
  std::string text;                  // byte for byte
  std::string name;                  // of the file, unless the file says otherwise
  std::filesystem::path robot;       // found from the folder of the task file
  std::vector<TaskFile> tasks;       // in the file's order, at least one; names differ
  std::string outer;                 // name of the term that is the outer objective J, or empty
  double outer_weight = 1.0;         // of J in F + weight·J
  DesignTable design;                // [design]: what is frozen or bounded
  std::map<std::string, int> lines;  // of the keys outside [[task]]

  bool joint() const { return tasks.size() > 1; }
};

/// Reads a task file strictly, with all its tasks. [style], [limits] and [weights] outside [[task]]
/// hold for every task that does not say otherwise. Throws as read_task_file().
/// @param robot instead of the file's, from the working directory; empty: the file's
TaskSet read_task_set(const std::filesystem::path& file, const std::filesystem::path& robot = {});
/// The same from text; `file` is for messages and to find the robot from.
TaskSet parse_task_set(const std::string& text, const std::filesystem::path& file,
                       const std::filesystem::path& robot = {});

/// Reads the file of one task strictly: TOML 1.0, known keys only, right types, finite and in
/// range. Throws InputError with one line for each thing that is wrong; also where the file or its
/// robot is missing, or where it holds several tasks.
TaskFile read_task_file(const std::filesystem::path& file);
/// The same from text; `file` is for messages and to find the robot from.
TaskFile parse_task_file(const std::string& text, const std::filesystem::path& file);

/// The text of a task file with `robot = "robot.xml"`, everything else byte for byte: what can be
/// run again beside a copy of the robot under that name.
std::string text_beside_robot(const std::string& text);

/// The task for this robot: gait pattern chosen, feet put in the robot's order, seconds turned into
/// knots. Throws InputError, with file and line of the key, where task and robot do not fit or the
/// speed is out of reach.
Task make_task(const TaskFile& file, const RobotModel& robot);

/// Knots planted on either side of stance: `seconds` in knots, at least one. Without a margin in
/// the task touchdown_error() of the leg's length (35 ms for legs of 21 cm) for gaits of duty ≤
/// 0.6, else one knot.
int planted_margin_knots(std::optional<double> seconds, double duty, double time_step,
                         double leg_length);

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
