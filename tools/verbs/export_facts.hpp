// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjcf/propose/home_touches.hpp"
#include "mjcf/read/read_robot.hpp"
#include "tools/run/export_readme.hpp"
#include "tools/run/judged_sums.hpp"
#include "tools/run/run_record.hpp"
#include "tools/simulate/stand.hpp"

namespace legwright {

/// The robot of a run, before and after.
struct ExportedRun {
  RunRecord run;
  JudgedSums sums;  // of what stands in the folder, before it was read
  RobotModel before, after;
  bool holds_home = false;  // `after` has controls in its home keyframe that the result has not
  std::string drawn;        // where the result draws its feet, which a keyframe of `after` mends
  double lifted = 0.0;  // [m]: keyframes of the result are so much deeper in the ground than here
};

/// Throws IoError where there is no run or no result, InputError where inputs or result are not
/// those that the run started from and ended with.
ExportedRun read_exported_run(const std::filesystem::path& root);

/// What can be told of the robot before its folder is written.
/// @param name of the robot's file, without .xml
ExportFacts facts_of(const ExportedRun& from, const std::filesystem::path& root,
                     const std::string& name);

/// Of the floor that the robot was designed for; of several tasks the first one's.
double friction_of(const RunRecord& run);

/// Pairs that touch in the home pose of the result and did not before.
std::vector<HomeTouch> home_touches(const ExportedRun& run);

/// What a second of standing showed, as a sentence of Markdown.
std::string describe(const StandingResult& stand);

}  // namespace legwright
