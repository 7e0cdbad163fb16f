// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace legwright {

/// A design parameter before and after.
struct ExportedParameter {
  std::string name, unit, sentence;
  double before = 0.0, after = 0.0;
};

/// What the README of an exported robot tells.
struct ExportFacts {
  std::string name;                      // of the robot's file, without .xml
  std::string model;                     // as the file calls itself
  std::string robot_file, robot_sha256;  // where it comes from
  std::string task_file, task_sha256;
  std::vector<std::string> limits;                          // by which they were judged: SHA-256
  std::vector<std::pair<std::string, std::string>> scenes;  // of the run, which are judged: SHA-256
  std::string version, engine;                              // of Legwright and of MuJoCo
  std::string command;                                      // that made the run
  std::string status;                                       // how the run ended
  std::vector<ExportedParameter> parameters;
  double mass_before = 0.0, mass_after = 0.0;  // [kg]
  std::vector<std::string> verdicts;           // of physics; none: it was not validated
  std::string chosen_verdict;                  // as the search played its result, or empty
  std::optional<double> servo_kp;              // least that the gait was judged with [N m/rad]
  std::string standing;                        // what a second of standing showed
  std::string touches;  // what of its body touches itself at home, which did not before; or empty
  std::string picture;  // file, or empty
  std::vector<std::string> licences;  // files
  std::vector<std::string> others;    // files that the robot's names: parts and assets
  bool urdf = false;
  std::vector<std::string> urdf_lost;  // what URDF cannot say of it
  std::string ros_package;             // its name, or empty
  std::vector<std::string> gaits;      // tasks whose gaits are here; one empty name for one task
};

/// README.md of an exported robot: what it is, where it comes from, what changed. Texts from files
/// are escaped: names cannot bring markup.
std::string export_readme(const ExportFacts& facts);

}  // namespace legwright
