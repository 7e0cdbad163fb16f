// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>
#include <set>

#include "mjcf/input_error.hpp"
#include "mjcf/legs.hpp"
#include "mjcf/proposals.hpp"
#include "tools/io/atomic_file.hpp"
#include "tools/io/clean_text.hpp"
#include "tools/io/io_error.hpp"
#include "tools/io/json_file.hpp"
#include "tools/io/starter_task.hpp"
#include "tools/verbs/summary.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct InitOptions {
  std::string robot, output, task, gait;
  bool write = false, json = false;
};

std::string range_text(const Joint& joint) {
  if (!std::isfinite(joint.lower) && !std::isfinite(joint.upper)) return "any angle";
  return fmt::format("{:.3g} to {:.3g} rad", joint.lower, joint.upper);
}

std::string limit_text(const Servo& servo) {
  const char* const unit = servo.tendon.empty() ? "N m" : "N";
  const std::string by = servo.tendon.empty() ? "" : fmt::format(" along tendon {}", servo.tendon);
  return (std::isfinite(servo.torque_limit)
              ? fmt::format("up to {:.4g} {}", servo.torque_limit, unit)
              : "no limit") +
         by;
}

/// One line for a joint of a limb, by its place in the chain from the trunk down.
std::string joint_text(const StudiedRobot& found, const Limb& limb, std::size_t place) {
  const auto link = static_cast<std::size_t>(limb.links[place]);
  const Joint& joint = found.model.morphology.links[link].joint;
  return fmt::format("      {:24} {:8} {:22} {}\n", joint.name, axis_name(limb.axes[place]),
                     range_text(joint), limit_text(found.model.servos[link - 1]));
}

/// Joints between the trunk and several limbs, each once.
std::string shared_text(const StudiedRobot& found) {
  std::set<int> told;
  std::string text;
  for (const Limb& limb : found.limbs)
    for (std::size_t k = 0; k < static_cast<std::size_t>(limb.shared); ++k)
      if (told.insert(limb.links[k]).second) text += joint_text(found, limb, k);
  return text.empty() ? "" : "  above several limbs\n" + text;
}

/// One line per joint that moves this limb alone, from the trunk down.
std::string limb_text(const StudiedRobot& found, const Limb& limb) {
  const Morphology& morphology = found.model.morphology;
  std::string text;
  for (auto k = static_cast<std::size_t>(limb.shared); k < limb.links.size(); ++k)
    text += joint_text(found, limb, k);
  const Foot& foot = morphology.feet[static_cast<std::size_t>(limb.foot)];
  std::string shape =
      foot.radius > 0.0 ? fmt::format("ball of {:.3g} m", foot.radius) : "point of a foot";
  if (const auto& others = found.model.structure.feet[static_cast<std::size_t>(limb.foot)].others;
      !others.empty())
    shape = fmt::format("{}, middle of {} alike,", shape, 1 + others.size());
  return text + fmt::format("      {:24} {} at {:.3f} {:.3f} {:.3f} m\n", foot.name, shape,
                            limb.home.x(), limb.home.y(), limb.home.z());
}

std::string tree_text(const StudiedRobot& found) {
  const Morphology& morphology = found.model.morphology;
  std::string text = fmt::format("{}: {:.4g} kg, {} limbs, {} joints\n  trunk '{}'\n",
                                 morphology.name, morphology.total_mass(), morphology.foot_count(),
                                 morphology.joint_count(), found.model.root_body) +
                     shared_text(found);
  const int rows = found.limbs.empty() ? 0 : found.limbs.back().row + 1;
  for (std::size_t k = 0; k < found.limbs.size(); ++k) {
    const Limb& limb = found.limbs[k];
    if (limb.partner >= 0 && limb.partner < static_cast<int>(k)) continue;  // told with the other
    const std::string row = row_name(limb.row, rows);
    const std::string pair = limb.partner < 0
                                 ? "limb without a mirror image"
                                 : (row.empty() ? "pair of limbs" : row + " pair of limbs");
    text += fmt::format("  {}\n{}", pair, limb_text(found, limb));
    if (limb.partner >= 0)
      text += limb_text(found, found.limbs[static_cast<std::size_t>(limb.partner)]);
  }
  text += held_text(found.model.structure);
  return found.not_standing.empty() ? text : text + "  " + found.not_standing + "\n";
}

std::string proposals_text(const StudiedRobot& found) {
  std::string text;
  if (found.model.space.size() > 0) {
    text +=
        fmt::format("the file declares {} design parameters already:", found.model.space.size());
    for (const DesignParameter& parameter : found.model.space.parameters)
      text += " " + parameter.name;
    text += "\n";
  }
  text += fmt::format("{} design parameters {}:\n", found.proposals.size(),
                      found.model.space.size() > 0 ? "could be added" : "are proposed");
  std::size_t width = 0;
  for (const Proposal& p : found.proposals) width = std::max(width, p.name.size());
  for (const Proposal& p : found.proposals)
    text += fmt::format("  {:{}}  {:8.4f}  {:8.4f} to {:8.4f} {:3}  {}\n", p.name, width, p.value,
                        p.lower, p.upper, p.unit, p.sentence);
  for (const std::string& line : found.left_out) text += "  left out  " + line + "\n";
  return text;
}

Json to_json(const StudiedRobot& found, const std::string& written, const std::string& task) {
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
          {"not_standing", found.not_standing.empty() ? Json(nullptr) : Json(found.not_standing)},
          {"declared", declared},
          {"proposals", proposals},
          {"left_out", found.left_out},
          {"written", written.empty() ? Json(nullptr) : Json(written)},
          {"task", task.empty() ? Json(nullptr) : Json(task)}};
}

/// The text of the starter task, which names `robot` from the folder of the task file. Throws IoError where the file
/// exists already.
std::string task_text(const InitOptions& options, const StudiedRobot& found,
                      const std::string& robot) {
  if (fs::exists(options.task))
    throw IoError(options.task + ": exists already; name a new file, or remove it");
  if (fs::weakly_canonical(fs::absolute(options.task)) == fs::weakly_canonical(fs::absolute(robot)))
    throw IoError(options.task + ": the robot is written there; name another file for the task");
  if (!found.not_standing.empty())
    throw InputError(options.robot, 0, "",
                     "no task is written, in which the robot would fall at once, nor anything "
                     "else: " +
                         found.not_standing);
  const std::optional<std::string> gait =
      options.gait.empty() ? std::nullopt : std::optional(options.gait);
  const fs::path folder = fs::absolute(options.task).lexically_normal().parent_path();
  const fs::path named = fs::absolute(robot).lexically_normal().lexically_proximate(folder);
  const StarterTask task = starter_task(found.model, gait);
  if (!(task.period > 0.0) || !std::isfinite(task.period))
    throw InputError(options.robot, 0, "",
                     "no task is written: in the home pose the feet are not below the centre of "
                     "mass, so a gait has no period; give the file a keyframe named home in which "
                     "the feet carry the trunk");
  return starter_text(task, named.generic_string());
}

std::string next_step(const InitOptions& options, const StudiedRobot& found,
                      const std::string& written) {
  if (!options.task.empty())
    return fmt::format("next: legwright optimize {} -o runs/mine\n", shell_word(options.task));
  if (!written.empty())
    return "next: a task file (legwright init ROBOT --task FILE writes one), then legwright check "
           "TASK\n";
  if (found.proposals.empty()) return "";
  return fmt::format(
      "next: legwright init {} --write --task task.toml   puts them into the file's <custom> "
      "section and writes a first task\n",
      shell_word(options.robot));
}

/// Other files are named by paths from the main file's folder.
void check_output(const InitOptions& options, const RobotFiles& files) {
  if (options.output.empty() || (files.includes().empty() && files.assets().empty())) return;
  const fs::path from = fs::weakly_canonical(fs::absolute(files.file())).parent_path(),
                 to = fs::weakly_canonical(fs::absolute(options.output)).parent_path();
  if (from != to)
    throw InputError(options.output, 0, "",
                     fmt::format("the robot includes other files or has meshes, which are found "
                                 "from the folder {} only; write the output there",
                                 from.string()));
}

int init(const InitOptions& options) {
  const fs::path file = options.robot;
  if (!options.gait.empty() && options.task.empty())
    throw InputError("--gait is for the task file that --task FILE writes; give both");
  const RobotFiles files = RobotFiles::read(file);
  const StudiedRobot found = files.at_their_lines([&] { return study_robot(files.text(), file); });
  check_output(options, files);
  const std::string task =
      options.task.empty()
          ? ""
          : task_text(options, found, options.output.empty() ? options.robot : options.output);
  std::string written;
  if (options.write || !options.output.empty()) {
    written = options.output.empty() ? options.robot : options.output;
    if (!options.output.empty() && fs::exists(options.output) &&
        !fs::equivalent(options.output, file))
      throw IoError(options.output + ": exists already; name a new file, or remove it");
    if (found.proposals.empty() && options.output.empty())
      written.clear();  // nothing to add
    else
      write_file(written, with_declarations(files.main_text(), file, found.proposals));
  }
  if (!task.empty()) write_file(options.task, task);
  if (options.json) {
    fmt::print("{}", to_text(to_json(found, written, options.task)));
    return kOk;
  }
  fmt::print("{}", terminal_text(tree_text(found) + proposals_text(found)));
  for (const std::string& path : {written, options.task})
    if (!path.empty()) fmt::print("written  {}\n", shell_word(path));
  fmt::print("{}", next_step(options, found, written));
  return kOk;
}

}  // namespace

void add_init(CLI::App& program, Action& action) {
  const auto options = std::make_shared<InitOptions>();
  CLI::App* verb = program.add_subcommand(
      "init", "Study a robot (MJCF), propose what a designer may change in it");
  verb->add_option("ROBOT", options->robot, "MJCF file of the robot")->required();
  verb->add_flag("--write", options->write,
                 "write the proposals into the file's <custom> section; all other bytes stay");
  verb->add_option("-o,--output", options->output, "write to this new file instead");
  verb->add_option("--task", options->task,
                   "write a first task for the robot, by its size, to this new file");
  verb->add_option("--gait", options->gait,
                   "of that task; default: trot for four feet, tripod for six, walk for two");
  verb->add_flag("--json", options->json, "print one JSON document");
  verb->footer(
      "Prints the tree that was found (limbs front to hind, mirror images as pairs) and proposes: "
      "lengths of links,\n"
      "directions of joint axes, length and width of the trunk, attachments of linear actuators. "
      "What the file's\n"
      "construction does not allow is left out, with the reason. Edit bounds, or delete what shall "
      "not change.");
  verb->callback([&action, options] { action = [options] { return init(*options); }; });
}

}  // namespace legwright
