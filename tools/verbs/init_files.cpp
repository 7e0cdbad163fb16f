// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/init_files.hpp"

#include <fmt/format.h>

#include "mjcf/propose/declare.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/splice.hpp"
#include "mjcf/urdf/read_urdf.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/new_files.hpp"
#include "tools/run/robot_folder.hpp"
#include "tools/verbs/summary.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// A task in the place of its robot is told by what to do with it.
void refuse_task(const fs::path& file) {
  if (file.extension() != ".toml") return;
  throw InputError(file.string(), 0, "",
                   fmt::format("found a task file (TOML), expected the robot (MJCF) that it names; "
                               "`legwright check {0}` explains the task, `legwright optimize {0}` "
                               "runs it",
                               shell_word(file.string())));
}

/// The same reasons without lines, which are not those of the user's file.
InputError of_made_mjcf(const InputError& error) {
  if (!error.reasons().empty()) {
    std::vector<InputError> reasons;
    for (const InputError& reason : error.reasons()) reasons.push_back(of_made_mjcf(reason));
    return InputError(std::move(reasons));
  }
  std::string message = error.message();
  if (const std::size_t at = message.find(", line "); at != std::string::npos)
    message.erase(at, message.find_first_not_of("0123456789", at + 7) - at);
  return {error.file(), 0, error.where(), message};
}

RobotFiles in_pose(const RobotFiles& files, const std::optional<StandingPose>& pose) {
  return pose ? files.with_main(with_keyframe(files.main_text(), files.file(), *pose)) : files;
}

/// What was found in a robot's files, with the pose and the names that it lacks.
/// @param pose find_standing_pose() of it
StudiedRobot study(const RobotFiles& given, std::optional<StandingPose> pose) {
  const fs::path& file = given.file();
  std::string text = given.main_text();
  RobotFiles files = in_pose(given, pose);
  ProposedParameters found =
      files.at_their_lines([&] { return propose_parameters(files.text(), file); });
  std::set<std::string> named = found.unnamed;
  if (!named.empty()) {
    files = files.with_main(with_named_bodies(files.main_text(), file, named));
    found = files.at_their_lines([&] { return propose_parameters(files.text(), file); });
    for (const std::string& still : found.unnamed) named.erase(still);
  }
  return {std::move(files),
          std::move(found),
          std::move(pose),
          std::move(text),
          std::move(named),
          false,
          {}};
}

StudiedRobot study_urdf(std::string text, const fs::path& file, const FileReach& reach) {
  MjcfOfUrdf made = mjcf_of_urdf(text, file);
  try {
    const RobotFiles plain = RobotFiles::from_text(std::move(made.text), file, reach);
    std::optional<StandingPose> pose = find_standing_pose(plain.text(), file);
    made = mjcf_of_urdf(text, file, mending_of(parse_robot(in_pose(plain, pose).text(), file)));
    // Gains and exclusions are no part of where a robot stands.
    StudiedRobot robot =
        study(RobotFiles::from_text(std::move(made.text), file, reach), std::move(pose));
    robot.text = std::move(text);
    robot.of_urdf = true;
    robot.mended = std::move(made.notes);
    return robot;
  } catch (const InputError& error) {
    throw of_made_mjcf(error);
  }
}

}  // namespace

StudiedRobot study_robot(const fs::path& file, const FileReach& reach) {
  refuse_task(file);
  std::string text = read_main_file(file);
  if (is_urdf(text)) return study_urdf(std::move(text), file, reach);
  const RobotFiles files = RobotFiles::from_text(std::move(text), file, reach);
  return study(files, find_standing_pose(files.text(), file));
}

std::string write_proposals(const StudiedRobot& robot, const std::string& output) {
  const fs::path& file = robot.files.file();
  const bool onto_itself = output.empty() || (fs::exists(output) && fs::equivalent(output, file));
  if (robot.of_urdf && onto_itself)
    throw InputError(file.string(), 0, "",
                     "is a URDF, which has no place for design parameters; -o ROBOT.xml writes it "
                     "as MJCF with them");
  if (!output.empty() && !onto_itself) refuse_existing(output);
  if (robot.found.proposals.empty() && !robot.pose && output.empty()) return "";  // nothing to add
  std::string written = output.empty() ? file.string() : output;
  const std::string text = with_declarations(robot.files.main_text(), file, robot.found.proposals);
  if (const std::string now = read_file(file); now != robot.text && now != text)
    throw IoError(file.string() + ": has been changed since it was studied; study it again");
  if (output.empty())
    write_file(written, text);
  else
    write_main_file(output, robot.files.with_main(text));
  return written;
}

}  // namespace legwright
