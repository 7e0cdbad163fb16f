// SPDX-License-Identifier: Apache-2.0
#include "tools/adopt/studied_robot.hpp"

#include <fmt/format.h>

#include "mjcf/propose/declare.hpp"
#include "mjcf/propose/doubtful_masses.hpp"
#include "mjcf/propose/trunk_element.hpp"
#include "mjcf/read/read_robot.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/splice.hpp"
#include "mjcf/text/text_edits.hpp"
#include "mjcf/urdf/read_urdf.hpp"
#include "tools/adopt/urdf_words.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/new_files.hpp"
#include "tools/files/shell_word.hpp"
#include "tools/run/robot_folder.hpp"

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

/// A reason in words of a URDF, without its line, which is not one of the user's file.
InputError of_urdf(const InputError& error) {
  std::string message = error.message();
  if (const std::size_t at = message.find(", line "); at != std::string::npos)
    message.erase(at, message.find_first_not_of("0123456789", at + 7) - at);
  return {error.file(), 0, in_words_of_urdf(error.where()), in_words_of_urdf(message)};
}

/// The same reasons without lines, and what was left out on the way, which may be why.
InputError of_made_mjcf(const InputError& error, const MjcfOfUrdf& made) {
  std::vector<InputError> reasons;
  for (const InputError& reason : error.reasons()) reasons.push_back(of_urdf(reason));
  if (reasons.empty()) reasons.push_back(of_urdf(error));
  for (const std::string& note : made.left_out)
    reasons.emplace_back(reasons.front().file(), 0, "note", note);
  return InputError(std::move(reasons));
}

RobotFiles in_pose(const RobotFiles& files, const std::optional<StandingPose>& pose) {
  return pose ? files.with_main(with_keyframe(files.main_text(), files.file(), *pose)) : files;
}

/// The pose to stand in that a robot lacks, and why it has none.
struct FoundPose {
  std::optional<StandingPose> pose;
  std::string none;
};

FoundPose pose_of(const RobotFiles& files) {
  FoundPose out;
  out.pose = find_standing_pose(files.text(), files.file(), &out.none);
  return out;
}

/// Whether a fault is of what <custom> declares, which no pose mends.
bool is_of_declarations(const InputError& error) {
  const std::string& where = error.reasons().empty() ? error.where() : error.reasons()[0].where();
  return where.starts_with("numeric") || where.starts_with("text");
}

/// What `work` makes, or why it could not be made and what may be why: that no pose was found, and
/// masses that cannot be where they are.
template <class Work>
auto told_of_pose(const FoundPose& found, const RobotFiles& files, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    const std::vector<std::string> doubts = doubtful_masses(files);
    if ((found.none.empty() && doubts.empty()) || is_of_declarations(error)) throw;
    const std::string file = files.file().string();
    std::vector<InputError> reasons = error.reasons();
    if (reasons.empty()) reasons.push_back(error);
    if (!found.none.empty()) reasons.emplace_back(file, 0, "pose", found.none);
    for (const std::string& doubt : doubts) reasons.emplace_back(file, 0, "note", doubt);
    throw InputError(std::move(reasons));
  }
}

/// What was found in a robot's files, with the pose and the names that it lacks.
StudiedRobot study(const RobotFiles& given, std::optional<StandingPose> pose,
                   const Forward& forward) {
  const fs::path& file = given.file();
  std::string text = given.main_text();
  RobotFiles files = in_pose(given, pose);
  ProposedParameters found =
      files.at_their_lines([&] { return propose_parameters(files.text(), file, forward); });
  std::set<std::string> named = found.unnamed;
  if (!named.empty()) {
    files = files.with_main(with_named_bodies(files.main_text(), file, named));
    found = files.at_their_lines([&] { return propose_parameters(files.text(), file, forward); });
    for (const std::string& still : found.unnamed) named.erase(still);
  }
  return {std::move(files),
          std::move(found),
          std::move(pose),
          std::move(text),
          std::move(named),
          false,
          {},
          {},
          {},
          {},
          {},
          {}};
}

/// The same robot, its bodies that overlap in every pose told to pass, which is studied anew.
StudiedRobot let_pass(StudiedRobot robot, const Forward& forward) {
  const fs::path& file = robot.files.file();
  std::vector<std::string> lines;
  robot.excluded = lasting_overlaps(robot.found.model);
  for (const BodyTouch& touch : robot.excluded)
    lines.push_back(fmt::format("<exclude body1=\"{}\" body2=\"{}\"/>", escape_xml(touch.first),
                                escape_xml(touch.second)));
  if (lines.empty()) return robot;
  robot.files =
      robot.files.with_main(with_lines_in_section(robot.files.main_text(), file, "contact", lines));
  robot.found = robot.files.at_their_lines(
      [&] { return propose_parameters(robot.files.text(), file, forward); });
  return robot;
}

/// The robot with the trunk's frame that is sought.
RobotFiles in_axes(const RobotFiles& files, const std::optional<TrunkAxes>& axes) {
  return axes ? with_upright_axes(files, *axes) : files;
}

/// The same, or nothing where the main file does not hold what would be turned.
std::optional<RobotFiles> turned_where_it_can_be(const RobotFiles& files, const TrunkAxes& axes) {
  try {
    return with_upright_axes(files, axes);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// How a robot's trunk has to be turned, and the pose in which it stands then.
struct TurnedRobot {
  std::optional<TrunkAxes> axes;
  RobotFiles files;  // turned so
  FoundPose found;
  std::string left;  // what is told of a trunk that is left as it is
};

TurnedRobot stood_up(const RobotFiles& drawn) {
  std::optional<TrunkAxes> axes = find_trunk_axes(drawn.text(), drawn.file());
  std::optional<RobotFiles> turned;
  std::string left;
  if (axes)
    turned = axes->upright ? turned_where_it_can_be(drawn, *axes) : with_upright_axes(drawn, *axes);
  if (axes && !turned) {
    left = axes->why +
           "; ahead, left and right are along its axes, as the main file holds neither "
           "the trunk nor all keyframes, which init would turn";
    axes.reset();
  }
  RobotFiles files = turned.value_or(drawn);
  FoundPose found = pose_of(files);
  if (!axes && !found.none.empty())
    if (auto lying = find_lying_trunk_axes(drawn.text(), drawn.file()))
      if (auto up = turned_where_it_can_be(drawn, *lying))
        if (FoundPose stands = pose_of(*up); stands.pose)
          return {std::move(lying), std::move(*up), std::move(stands), ""};
  return {std::move(axes), std::move(files), std::move(found), std::move(left)};
}

StudiedRobot study_urdf(std::string text, const fs::path& file, const FileReach& reach,
                        const Forward& forward) {
  UrdfReader reader(text, file, reach);
  MjcfOfUrdf made = reader.read();
  try {
    const RobotFiles drawn = RobotFiles::from_text(std::move(made.text), file, reach);
    const TurnedRobot turned = stood_up(drawn);
    const RobotModel posed = told_of_pose(turned.found, turned.files, [&] {
      return parse_robot(in_pose(turned.files, turned.found.pose).text(), file);
    });
    made = reader.read(mending_of(posed, made.without_moments));
    // Gains and exclusions are no part of where a robot stands.
    StudiedRobot robot =
        study(in_axes(RobotFiles::from_text(std::move(made.text), file, reach), turned.axes),
              turned.found.pose, forward);
    robot.text = std::move(text);
    robot.axes = turned.axes;
    robot.of_urdf = true;
    robot.mended = std::move(made.notes);
    return robot;
  } catch (const InputError& error) {
    throw of_made_mjcf(error, made);
  }
}

}  // namespace

StudiedRobot study_robot(const fs::path& file, const FileReach& reach, const Forward& forward) {
  refuse_task(file);
  std::string text = read_main_file(file);
  if (is_urdf(text)) return study_urdf(std::move(text), file, reach, forward);
  const RobotFiles read = RobotFiles::from_text(std::move(text), file, reach);
  std::string trunk, freed;
  const RobotFiles given = with_named_trunk(with_freed_trunk(read, &freed), &trunk);
  const std::optional<SixJointRoot> root = find_six_joint_root(given.text(), file);
  const RobotFiles drawn = root ? with_free_root(given, *root) : given;
  const TurnedRobot turned = stood_up(drawn);
  StudiedRobot robot = told_of_pose(turned.found, turned.files, [&] {
    return let_pass(study(turned.files, turned.found.pose, forward), forward);
  });
  robot.text = read.main_text();
  robot.axes = turned.axes;
  if (!turned.left.empty()) robot.found.remarks.insert(robot.found.remarks.begin(), turned.left);
  robot.root = root;
  robot.trunk = trunk;
  robot.freed = freed;
  return robot;
}

bool StudiedRobot::is_changed() const {
  return pose || axes || root || !trunk.empty() || !freed.empty() || !excluded.empty();
}

std::vector<std::string> changes_besides(const StudiedRobot& robot) {
  std::vector<std::string> out = robot.mended;
  if (!robot.trunk.empty())
    out.push_back(fmt::format("the trunk, which had no name, is called '{}'", robot.trunk));
  if (!robot.freed.empty()) out.push_back(robot.freed);
  if (robot.root)
    out.push_back(fmt::format("a free joint in the place of the six by which the trunk '{}' floats",
                              robot.root->body));
  if (robot.axes)
    out.push_back(fmt::format("{}: what stands in it goes into <frame quat=\"{}\">",
                              robot.axes->why, fmt::join(robot.axes->frame, " ")));
  if (!robot.excluded.empty()) out.push_back(excluded_words(robot.excluded));
  return out;
}

std::vector<std::string> told_of(const StudiedRobot& robot) {
  std::vector<std::string> out = changes_besides(robot);
  if (robot.pose)
    out.push_back(
        fmt::format("a pose to stand in is found for it, as its home pose is none: {}; {}",
                    robot.pose->why, robot.pose->words));
  if (!robot.named.empty())
    out.push_back(
        fmt::format("the bodies of the joints {}, which had no name, are called after them",
                    fmt::join(robot.named, ", ")));
  out.insert(out.end(), robot.found.remarks.begin(), robot.found.remarks.end());
  return out;
}

RobotFiles with_declared(const StudiedRobot& robot, const std::vector<Proposal>& chosen) {
  return robot.files.with_main(
      with_declarations(robot.files.main_text(), robot.files.file(), chosen));
}

std::string write_proposals(const StudiedRobot& robot, const std::string& output) {
  const fs::path& file = robot.files.file();
  const bool onto_itself = output.empty() || (fs::exists(output) && fs::equivalent(output, file));
  if (robot.of_urdf && onto_itself)
    throw InputError(file.string(), 0, "",
                     "is a URDF, which has no place for design parameters; -o ROBOT.xml writes it "
                     "as MJCF with them");
  if (!output.empty() && !onto_itself) refuse_existing(output);
  if (robot.found.proposals.empty() && !robot.is_changed() && output.empty())
    return "";  // nothing to add
  std::string written = output.empty() ? file.string() : output;
  const RobotFiles declared = with_declared(robot, robot.found.proposals);
  const std::string& text = declared.main_text();
  if (const std::string now = read_file(file); now != robot.text && now != text)
    throw IoError(file.string() + ": has been changed since it was studied; study it again");
  if (output.empty())
    write_file(written, text);
  else
    write_main_file(output, declared);
  return written;
}

}  // namespace legwright
