// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mjcf/propose/facing.hpp"
#include "mjcf/read/read_robot.hpp"
#include "tools/session/command.hpp"
#include "tools/studio/allowed_paths.hpp"

namespace legwright {

/// What a path that is opened has to say.
struct Opening {
  std::filesystem::path origin;          // what was opened
  std::string label;                     // what its robot is called in lists and names of folders
  std::filesystem::path robot_file;      // of that robot, where the user has it
  std::optional<RobotModel> robot;       // none: only `proposes`
  std::string text;                      // of the task file
  std::filesystem::path file;            // its name, for messages
  std::vector<SessionCommand> commands;  // that lead to where it stood
  std::filesystem::path taken_up;        // a kept session that this goes on with
  std::optional<std::string> assembly;   // the text of what is assembled, in the place of a robot
  std::filesystem::path judged;          // the run whose verdict is on what is opened
  std::string note;                      // what whoever opens it has to know; may be empty
  bool of_modules = false;               // a robot that was built of the assembly that is open
  bool proposes = false;  // a robot that declares nothing yet: what may change is to be chosen
};

/// Reads a robot's MJCF, a task file, an assembly, the folder of a run or that of a kept
/// session. A robot alone gets a first task by its size. A run goes on from its journal, one that
/// no session wrote from its result. Throws InputError and IoError that name what is wrong with it.
/// @param paths what may be read
Opening open_path(const std::filesystem::path& path, const AllowedPaths& paths);

/// The design parameters within the bounds of the tasks. Throws InputError where tasks and robot do
/// not fit: before what is open is closed for them.
DesignSpace check_fit(const Opening& opening);

/// A robot and the first task by its size. Throws InputError where there is none for it.
/// @param ahead where it faces; nothing: as it seems to be drawn
Opening open_robot(RobotModel robot, const std::filesystem::path& origin,
                   const Forward& ahead = {});

}  // namespace legwright
