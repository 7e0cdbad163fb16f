// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "mjcf/propose/doubtful_masses.hpp"
#include "mjcf/read/world_parts.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "optimizer/motion/faced_frame.hpp"
#include "tools/adopt/studied_robot.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/files/new_files.hpp"
#include "tools/files/shell_word.hpp"
#include "tools/task/starter_task.hpp"
#include "tools/verbs/init_text.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct InitOptions : ReadingOptions {
  std::string robot, output, task, gait, forward;
  bool write = false, json = false;
};

/// How the trunk's frame is turned.
std::string axes_text(const StudiedRobot& robot, bool writes) {
  if (!robot.axes) return "";
  return fmt::format("turned   {}\n         what stands in it {} into <frame quat=\"{}\">{}\n",
                     robot.axes->why, writes || robot.of_urdf ? "is put" : "has to be put",
                     fmt::join(robot.axes->frame, " "),
                     writes || robot.of_urdf ? "" : ", as --write does");
}

/// What had the place of the trunk's free joint.
std::string root_text(const StudiedRobot& robot, bool writes) {
  if (!robot.freed.empty())
    return fmt::format("floats   by {}{}\n", robot.freed,
                       writes ? "; keyframes follow" : " (--write puts it there)");
  if (!robot.root) return "";
  const std::vector<std::string>& carriers = robot.root->carriers;
  const std::string chain =
      carriers.empty() ? ""
                       : fmt::format("         with them {} that only carr{} it: {}\n",
                                     carriers.size() == 1 ? "goes the body" : "go the bodies",
                                     carriers.size() == 1 ? "ies" : "y", fmt::join(carriers, ", "));
  return fmt::format(
             "floats   the trunk '{}', by six joints in the file: {}\n"
             "         a free joint {} in their place{}\n",
             robot.root->body, fmt::join(robot.root->joints, ", "),
             writes ? "is put" : "has to be put",
             writes ? "; keyframes follow" : ", as --write does") +
         chain;
}

Json root_json(const StudiedRobot& robot) {
  if (!robot.root) return nullptr;
  return {{"body", robot.root->body}, {"joints", robot.root->joints}};
}

/// What init found to stand in, where the file has no such pose.
std::string pose_text(const StudiedRobot& robot, bool writes) {
  if (!robot.pose) return "";
  return fmt::format(
      "stands   in a pose that was found for it, as it does not in its home pose: {}\n"
      "         {}\n{}",
      robot.pose->why, robot.pose->words,
      writes          ? "         which is keyframe 'legwright' now\n"
      : robot.of_urdf ? "         the MJCF gets it as keyframe 'legwright'\n"
                      : "         --write adds it as keyframe 'legwright'\n");
}

/// Bodies that got a name: the trunk, and those whose lengths are declared by it.
std::string names_text(const StudiedRobot& robot, bool writes) {
  const char* const who = writes || robot.of_urdf ? "" : " (--write does)";
  std::string text;
  if (!robot.trunk.empty())
    text = fmt::format("named    the trunk, which {} none, '{}'{}\n", writes ? "had" : "has",
                       robot.trunk, who);
  if (!robot.named.empty())
    text += fmt::format("named    the bodies of the joints {}, which {} none, after them{}\n",
                        fmt::join(robot.named, ", "), writes ? "had" : "have", who);
  return text;
}

std::string remarks_text(const StudiedRobot& robot, const ProposedParameters& found) {
  std::string text;
  if (robot.of_urdf) text += "made     MJCF of this URDF:\n";
  for (const std::string& mended : robot.mended) text += "note     " + mended + "\n";
  if (!robot.excluded.empty()) text += "note     " + excluded_words(robot.excluded) + "\n";
  for (const std::string& remark : found.remarks) text += "note     " + remark + "\n";
  return text;
}

Json trunk_axes_json(const StudiedRobot& robot) {
  if (!robot.axes) return nullptr;
  return {{"why", robot.axes->why}, {"frame_quat", robot.axes->frame}};
}

Json to_json(const StudiedRobot& robot, const std::string& written, const std::string& task) {
  const ProposedParameters& found = robot.found;
  const Morphology& morphology = found.model.morphology;
  Json limbs = Json::array();
  for (const Limb& limb : found.limbs) {
    Json joints = Json::array();
    for (const int k : limb.links)
      joints.push_back(morphology.links[static_cast<std::size_t>(k)].joint.name);
    limbs.push_back({{"foot", morphology.feet[static_cast<std::size_t>(limb.foot)].name},
                     {"joints", joints},
                     {"row", limb.row},
                     {"partner", limb.partner < 0 ? Json(nullptr) : Json(limb.partner)},
                     {"home_m", {limb.home.x(), limb.home.y(), limb.home.z()}}});
  }
  Json held = Json::array();
  for (const FrozenJoint& frozen : found.model.structure.frozen)
    held.push_back({{"joint", frozen.name}, {"body", frozen.body}, {"why", frozen.why}});
  Json proposals = Json::array();
  for (const Proposal& p : found.proposals)
    proposals.push_back({{"name", p.name},
                         {"value", p.value},
                         {"lower", p.lower},
                         {"upper", p.upper},
                         {"unit", p.unit},
                         {"binding", p.binding},
                         {"sentence", p.sentence}});
  Json declared = Json::array();
  for (const DesignParameter& parameter : found.model.space.parameters)
    declared.push_back(parameter.name);
  return {{"schema", "legwright/init"},
          {"version", 1},
          {"robot", morphology.name},
          {"mass_kg", morphology.total_mass()},
          {"trunk", found.model.root_body},
          {"limbs", limbs},
          {"held", held},
          {"surroundings", surroundings_of(*compile_mjcf(found.model.xml, found.model.file))},
          {"not_standing", found.not_standing.empty() ? Json(nullptr) : Json(found.not_standing)},
          {"standing_pose",
           robot.pose ? Json{{"why", robot.pose->why}, {"qpos", robot.pose->qpos}} : Json(nullptr)},
          {"trunk_axes", trunk_axes_json(robot)},
          {"six_joint_root", root_json(robot)},
          {"declared", declared},
          {"proposals", proposals},
          {"left_out", found.left_out},
          {"named_bodies", robot.named},
          {"named_trunk", robot.trunk.empty() ? Json(nullptr) : Json(robot.trunk)},
          {"remarks", found.remarks},
          {"of_urdf", robot.of_urdf},
          {"mended", robot.mended},
          {"written", written.empty() ? Json(nullptr) : Json(written)},
          {"task", task.empty() ? Json(nullptr) : Json(task)}};
}

/// The file of the starter task, and what it asks for in words.
struct FirstTask {
  std::string text, words;
};

/// A URDF has no keyframes: how its MJCF gets the one that is asked for.
std::string way_to_keyframe(const ProposedParameters& found) {
  const ModelPointer model = compile_mjcf(found.model.xml, found.model.file);
  std::vector<std::string> joints;
  for (int j = 0; j < model->njnt; ++j)
    if (model->jnt_type[j] != mjJNT_FREE) joints.push_back(name_of(*model, mjOBJ_JOINT, j));
  return fmt::format(
      "; the same command without --task writes the MJCF that takes it. Its qpos is x y z of the "
      "trunk, its quaternion (1 0 0 0 is level), then the angles of {} [rad]",
      fmt::join(joints, ", "));
}

/// Masses that cannot be where they are, which may be why a robot does not stand.
std::string doubts_text(const ProposedParameters& found) {
  std::string text;
  for (const std::string& doubt : doubtful_masses(found.model)) text += "; note: " + doubt;
  return text;
}

/// It names `robot` from the folder of the task file. Throws IoError where the file exists already.
FirstTask first_task(const InitOptions& options, const StudiedRobot& studied,
                     const std::string& robot) {
  const ProposedParameters& found = studied.found;
  refuse_existing(options.task);
  if (same_place(options.task, robot))
    throw IoError(options.task + ": the robot is written there; name another file for the task");
  if (!found.not_standing.empty())
    throw InputError(options.robot, 0, "",
                     "no task is written, in which the robot would fall at once, nor anything "
                     "else: " +
                         found.not_standing + (studied.of_urdf ? way_to_keyframe(found) : "") +
                         doubts_text(found));
  const std::optional<std::string> gait =
      options.gait.empty() ? std::nullopt : std::optional(options.gait);
  const fs::path folder = fs::absolute(options.task).lexically_normal().parent_path();
  const fs::path named = fs::absolute(robot).lexically_normal().lexically_proximate(folder);
  StarterTask task = starter_task(found.model, gait);
  task.ahead = found.facing.ahead;
  if (!(task.period > 0.0) || !std::isfinite(task.period))
    throw InputError(options.robot, 0, "",
                     "no task is written: in the home pose the feet are not below the centre of "
                     "mass, so a gait has no period; give the file a keyframe named home in which "
                     "the feet carry the trunk" +
                         doubts_text(found));
  return {starter_text(task, named.generic_string()),
          fmt::format("{} at {:.2g} m/s, a cycle of {:.2g} s", task.gait, task.speed, task.period)};
}

/// A robot for which the library has no gait, or that would fall with any, gets its parameters all
/// the same, but no task.
bool lacks_task(const InitOptions& options, const ProposedParameters& found) {
  return options.gait.empty() && !no_task_text(found.model).empty();
}

/// To be said again by a command that studies the robot anew.
std::string forward_option(const InitOptions& options) {
  return options.forward.empty() ? "" : " --forward " + options.forward;
}

/// What makes init write a robot that it studied.
std::string writing_options(const StudiedRobot& robot) {
  if (!robot.of_urdf) return " --write";
  return " -o " + shell_word(robot.files.file().stem().string() + ".xml");
}

std::string next_step(const InitOptions& options, const StudiedRobot& robot,
                      const std::string& written, const std::string& task) {
  const ProposedParameters& found = robot.found;
  if (!task.empty())
    return fmt::format("next: legwright optimize {} -o {}\n", shell_word(task),
                       shell_word("runs/" + fs::path(task).stem().string()));
  const bool adds = written.empty() && (!found.proposals.empty() || robot.is_changed());
  if (lacks_task(options, found)) {
    const std::string gait = no_gait_text(found.model.morphology.foot_count());
    std::string text;
    if (adds)
      text = fmt::format("next: legwright init {}{}{}   {}\n", shell_word(options.robot),
                         forward_option(options), writing_options(robot),
                         robot.of_urdf ? "writes the robot as MJCF with them"
                                       : "puts them into the file's <custom> section");
    if (!gait.empty())
      text += fmt::format("{}: {}; then legwright check TASK\n", adds ? "then" : "next", gait);
    else if (options.task.empty())  // else stderr has it
      text += fmt::format("no task  {}\n", no_task_text(found.model));
    return text;
  }
  const bool makes = robot.of_urdf && written.empty();
  return fmt::format("next: legwright init {}{}{} --task task.toml   {}writes a first task\n",
                     shell_word(written.empty() ? options.robot : written), forward_option(options),
                     adds ? writing_options(robot) : "",
                     makes  ? "writes the robot as MJCF with them and "
                     : adds ? "puts them into the file's <custom> section and "
                            : "");
}

/// A task names the robot's file: none is written for one that has to be changed before it walks.
void refuse_task_for_the_file_as_it_is(const InitOptions& options, const StudiedRobot& robot) {
  if (options.task.empty() || options.write || !options.output.empty()) return;
  const auto refuse = [&](const std::string& why) {
    throw InputError(options.robot, 0, "", "no task is written" + why);
  };
  if (!robot.trunk.empty())
    refuse(": the trunk has no name in the file; add --write, which calls it '" + robot.trunk +
           "', or -o NEW.xml");
  if (robot.pose)
    refuse(", in which the robot would not stand: " + robot.pose->why +
           "; add --write, which puts the pose that was found into the file as keyframe "
           "'legwright'");
  if (robot.axes)
    refuse((robot.axes->upright ? ", in which ahead and sideways would be askew to its legs: "
                                : ", in which the robot would lie on its side: ") +
           robot.axes->why + "; add --write, which turns the trunk's frame");
  if (!robot.freed.empty())
    refuse(": it takes " + robot.freed + "; add --write, which puts it there, or -o NEW.xml");
  if (robot.root)
    refuse(
        fmt::format(": in the file six joints move the trunk '{}', and no free one; add "
                    "--write, which puts it there, or -o NEW.xml",
                    robot.root->body));
}

int init(const InitOptions& options) {
  if (!options.gait.empty() && options.task.empty())
    throw InputError("--gait is for the task file that --task FILE writes; give both");
  const Forward forward = facing_axis(options.forward);
  if (!options.forward.empty() && !forward)
    throw InputError(fmt::format(
        "--forward {}: expected the axis of the trunk's frame that it looks along: +x, -x, +y or "
        "-y",
        options.forward));
  const StudiedRobot robot = study_robot(options.robot, options.reach(), forward);
  const ProposedParameters& found = robot.found;
  if (robot.of_urdf && (options.write || !options.task.empty()) && options.output.empty())
    throw InputError(options.robot, 0, "",
                     "is a URDF, which a task cannot name and which has no place for design "
                     "parameters; add" +
                         writing_options(robot) + ", which writes it as MJCF");
  refuse_task_for_the_file_as_it_is(options, robot);
  const bool writes = options.write || !options.output.empty();
  const FirstTask task =
      options.task.empty() || lacks_task(options, found)
          ? FirstTask{}
          : first_task(options, robot, options.output.empty() ? options.robot : options.output);
  std::string written;
  const std::string written_task = task.text.empty() ? "" : options.task;
  const auto write_robot = [&] {
    if (writes) written = write_proposals(robot, options.output);
  };
  if (task.text.empty())
    write_robot();
  else
    write_new_files({{options.task, task.text}}, write_robot);
  const int code = task.text.empty() && !options.task.empty() ? kInfeasible : kOk;
  if (code != kOk)
    fmt::print(stderr, "legwright: {} is not written: {}\n", options.task,
               no_task_text(found.model));
  if (options.json) {
    fmt::print("{}", to_text(to_json(robot, written, written_task)));
    return code;
  }
  fmt::print("{}", terminal_text(root_text(robot, writes) + axes_text(robot, writes) +
                                 pose_text(robot, writes) + names_text(robot, writes) +
                                 remarks_text(robot, found)));
  fmt::print("{}", terminal_text(writes ? robot_summary(found)
                                        : robot_tree(found) + proposal_table(found) + "\n"));
  if (writes)
    fmt::print("{}", written.empty() ? declared_summary(found)
                                     : fmt::format("written  {}: {}", shell_word(written),
                                                   proposal_summary(found)));
  if (!written_task.empty()) fmt::print("written  {}: {}\n", shell_word(written_task), task.words);
  if (writes)
    fmt::print("more     legwright init {}   shows its legs and servos{}\n",
               shell_word(written.empty() ? options.robot : written),
               found.left_out.empty() ? ""
                                      : fmt::format(", and why {} more parameters were left out",
                                                    found.left_out.size()));
  fmt::print("{}", next_step(options, robot, written, written_task));
  return code;
}

}  // namespace

void add_init(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "init",
               "Study a robot (MJCF or URDF), propose what a designer may change in it", init);
  verb->add_option("ROBOT", options->robot, "MJCF or URDF file of the robot")->required();
  verb->add_flag("--write", options->write,
                 "write the proposals into the file's <custom> section; all other bytes stay");
  verb->add_option("-o,--output", options->output,
                   "write to this new file instead; a URDF becomes MJCF there");
  verb->add_option("--task", options->task,
                   "write a first task for the robot, by its size, to this new file");
  verb->add_option(
      "--gait", options->gait,
      "of that task; default: walk for two feet, trot for four, tripod for six, tetrapod for "
      "eight, wave for others");
  verb->add_option("--forward", options->forward,
                   "axis of the trunk's frame that it looks along: +x, -x, +y, -y; default: by "
                   "names, hips, a camera or how legs swing");
  verb->add_flag("--json", options->json, "print one JSON document");
  verb->footer(
      "Prints the tree that was found (legs front to hind, mirror images side by side) and "
      "proposes: lengths of links,\n"
      "directions of joint axes, length and width of the trunk, attachments of linear actuators. "
      "What the file's\n"
      "construction does not allow is left out, with the reason. A sentence on each goes into the "
      "file, and into --json.\n"
      "Edit bounds there, or delete what shall not change. What writes tells in short what was "
      "written. Where the library has no gait for so "
      "many feet, parameters\n"
      "are written and the task is not: exit code 1.");
}

}  // namespace legwright
