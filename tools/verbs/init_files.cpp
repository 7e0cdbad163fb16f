// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/init_files.hpp"

#include <fmt/format.h>

#include "mjcf/propose/declare.hpp"
#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
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

}  // namespace

StudiedRobot study_robot(const fs::path& file, const FileReach& reach) {
  refuse_task(file);
  RobotFiles files = RobotFiles::read(file, reach);
  std::string text = files.main_text();
  std::optional<StandingPose> pose = find_standing_pose(files.text(), file);
  if (pose) files = files.with_main(with_keyframe(text, file, *pose));
  ProposedParameters found =
      files.at_their_lines([&] { return propose_parameters(files.text(), file); });
  std::set<std::string> named = found.unnamed;
  if (!named.empty()) {
    files = files.with_main(with_named_bodies(files.main_text(), file, named));
    found = files.at_their_lines([&] { return propose_parameters(files.text(), file); });
    for (const std::string& still : found.unnamed) named.erase(still);
  }
  return {std::move(files), std::move(found), std::move(pose), std::move(text), std::move(named)};
}

std::string write_proposals(const StudiedRobot& robot, const std::string& output) {
  const fs::path& file = robot.files.file();
  if (!output.empty() && fs::exists(output) && !fs::equivalent(output, file))
    throw IoError(output + ": exists already; name a new file, or remove it");
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
