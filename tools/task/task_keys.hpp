// SPDX-License-Identifier: Apache-2.0
// What the keys of a task file say.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

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

  Eigen::Vector2d forward = Eigen::Vector2d::UnitX();  // where it faces, in the trunk's frame
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // forward, left of that
  double turn_rate = 0.0;
  // The plan's speeds over those that are wanted, and what it turns more [rad/s]: they make up for
  // what MuJoCo loses.
  double aim_speed = 1.0, aim_turn_rate = 0.0;
  double slope_along = 0.0,
         slope_across = 0.0;  // the ground rises on the way, to the left of it [rad]

  std::optional<double> com_height;       // or
  std::vector<double> com_heights;        // over the cycle
  std::vector<Eigen::Vector2d> com_path;  // off the wanted path, over the cycle
  std::map<std::string, std::vector<Eigen::Vector2d>>
      foot_targets;                                 // by the foot's name, over the cycle
  std::map<std::string, CycleTarget> foot_heights;  // by the foot's name
  std::map<std::string, CycleTarget> joint_angles;  // by the joint's name
  std::vector<Eigen::Vector2d>
      footprint;              // in footfall order; one entry: half length and half width
  double stance_width = 1.0;  // factor on how far feet are from the line of travel
  Task margins;  // friction … limb_pairs, payload, torque_limit, step_over and dynamics over Task's
                 // defaults
  std::optional<double> planted_margin;  // [s]
  std::map<std::string, double> weights;

  double weight = 1.0;  // w of F_joint = Σ w F; 1 where the file holds one task

  std::map<std::string, int> lines;  // of each key that is there, by its path: "gait.period"
  int line(const std::string& key) const;
  /// Throws InputError with file and line of the key.
  /// An error at the key's line.
  InputError refusal(const std::string& key, const std::string& message) const;
  [[noreturn]] void refuse(const std::string& key, const std::string& message) const;
};

/// What a task file says about s: [design] freeze = ["body_width", "front_*"] and [design.bounds]
/// body_length = [0.2, 0.3].
struct DesignTable {
  std::vector<std::string> freeze;                    // names or patterns: stay as they are
  std::map<std::string, std::vector<double>> bounds;  // lower, upper, within those of the robot
  std::map<std::string, double> given;  // what they were at first, where the robot has others now
};

/// Everything that a task file asks of one body: one task, or several under [[task]].
struct TaskSet {
  std::filesystem::path file;
  std::string text;                  // byte for byte
  std::string name;                  // of the file, unless the file says otherwise
  std::filesystem::path robot;       // found from the folder of the task file
  std::vector<TaskFile> tasks;       // in the file's order, at least one; names differ
  std::string outer;                 // name of the term that is the outer objective J, or empty
  std::string outer_source;          // where J comes from, if it is no term
  double outer_weight = 1.0;         // of J in F + weight·J
  DesignTable design;                // [design]: what is frozen or bounded
  std::map<std::string, int> lines;  // of the keys outside [[task]]

  int line(const std::string& key) const;

  bool joint() const { return tasks.size() > 1; }
};

}  // namespace legwright
