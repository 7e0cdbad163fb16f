// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "mjcf/scene/plain_scene.hpp"
#include "mjcf/text/input_error.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/files/licence.hpp"
#include "tools/files/shell_word.hpp"
#include "tools/files/unfinished_folder.hpp"
#include "tools/render/gl_context.hpp"
#include "tools/render/portrait.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/robot_label.hpp"
#include "tools/run/run_lock.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/verbs/export_facts.hpp"
#include "tools/verbs/export_files.hpp"
#include "tools/verbs/export_gait.hpp"
#include "tools/verbs/export_urdf.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct ExportOptions : ReadingOptions {
  std::string run, output;
  bool no_picture = false, urdf = false, ros = false, json = false;
};

/// Draws it, or says why not: a machine without OpenGL exports all the same.
std::string draw(const fs::path& scene, const std::string& png, const JudgedSums& of,
                 std::string& left_out) {
  try {
    pin_rasteriser();
    draw_portrait(scene, scene.parent_path() / png, origin_text(of));
    return png;
  } catch (const GlError& error) {
    left_out = error.what();
    return {};
  }
}

fs::path target_of(const ExportOptions& options) {
  fs::path out = options.output.empty()
                     ? fs::path("exports") / fs::absolute(options.run).lexically_normal().filename()
                     : fs::path(options.output);
  if (options.output.empty() && out.filename().empty())  // RUN ended with a slash
    out =
        fs::path("exports") / fs::absolute(options.run).lexically_normal().parent_path().filename();
  if (out.filename().empty()) out = out.parent_path();
  if (fs::exists(fs::symlink_status(out)))
    throw IoError(out.string() + ": exists already; name a new folder with -o, or remove it");
  return out;
}

/// The robot's file without .xml: none of its other files is called so, nor a scene or gait.
std::string robot_name(const ExportedRun& from) {
  const std::string* const told = from.run.files.find("robot.xml");
  const fs::path file = told ? *told : "";
  std::string name = plain_name(robot_label(from.after.morphology.name, file, file));
  if (name.empty()) name = "robot";
  if (name == "scene" || name == "walk" || name.ends_with("_walk")) name += "_robot";
  return free_name(std::move(name), from.after.files);
}

/// All files of a folder, sorted, from there on.
std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files.push_back(fs::relative(entry.path(), folder).generic_string());
  std::sort(files.begin(), files.end());
  return files;
}

void tell_people(const ExportFacts& facts, const fs::path& target, std::size_t files) {
  fmt::print("{}\n", terminal_text(facts.standing));
  for (const std::string& sentence : facts.urdf_lost)
    fmt::print("not in the URDF: {}\n", terminal_text(sentence));
  fmt::print(
      "written  {}: {} files\nnext: python {} --view{}   or: python -m mujoco.viewer --mjcf={}\n",
      shell_word(target.string()), files, shell_word((target / "play.py").string()),
      facts.gaits.front().empty() ? "" : " " + shell_word(facts.gaits.front()),
      shell_word((target / "scene.xml").string()));
}

int export_run(const ExportOptions& options) {
  const fs::path target = target_of(options);
  std::optional<RunLock> lock;
  if (const auto around = run_around(target)) lock.emplace(*around);
  options.check_run(options.run);
  const ExportedRun from = read_exported_run(options.run);
  const std::string name = robot_name(from);
  UnfinishedFolder folder(target);
  const fs::path robot = folder.path() / (name + ".xml"), scene = folder.path() / "scene.xml";
  const std::vector<std::string> others =
      write_robot(from.after.files, folder.path(), name + ".xml");
  write_file(scene, plain_scene(from.after, from.after.xml, name + ".xml", friction_of(from.run)));
  const std::vector<std::string> lost = differences_in_scene(robot, scene);
  if (!lost.empty())
    throw std::logic_error("the exported scene has another robot: " + lost.front());
  const StandingResult stood = stand(scene);

  ExportFacts facts = facts_of(from, options.run, name);
  facts.standing = describe(stood);
  if (from.holds_home)
    facts.standing +=
        " The ctrl of its home keyframe, which tells its servos that pose, is the export's: the "
        "robot's file has none.";
  if (from.lifted > 0.0)
    facts.standing += fmt::format(
        " Keyframes that have the feet in the ground in the robot's file have them on it here: the "
        "trunk is up to {:.3g} m higher.",
        from.lifted);
  if (!from.drawn.empty())
    facts.standing += " Its keyframe legwright is the export's: " + from.drawn + ".";
  facts.others = others;
  const std::vector<HomeTouch> touches = home_touches(from);
  facts.touches = describe(touches);
  try {
    facts.gaits = write_gaits(options.run, folder.path());
  } catch (const MujocoError& error) {
    throw InputError(std::string(error.what()) +
                     "; if it is the run's, `legwright optimize` makes it anew");
  }
  facts.urdf = options.urdf || options.ros;
  if (facts.urdf) facts.urdf_lost = write_urdf(from.after, folder.path(), name);
  if (options.ros) facts.ros_package = write_ros(from.after, options.run, folder.path(), name);
  std::string left_out;
  std::string picture = name + ".png";
  while (fs::exists(folder.path() / picture)) picture.insert(0, "picture_of_");  // a texture's
  if (!options.no_picture) facts.picture = draw(scene, picture, from.sums, left_out);
  facts.licences = copy_licences(ResultFolder::open(options.run).inputs(), folder.path());
  write_file(folder.path() / "README.md", export_readme(facts));
  const std::vector<std::string> files = files_in(folder.path());
  check_unchanged(options.run, from.sums, sums_of(options.run, from.run), "export");
  folder.appear();

  const bool healthy =
      stood.warnings.empty() && !stood.diverged && !stood.flew() && !stood.in_ground();
  if (!left_out.empty()) fmt::print(stderr, "legwright: warning: no picture: {}\n", left_out);
  if (!touches.empty())
    fmt::print(stderr, "legwright: warning: {}\n", terminal_text(facts.touches));
  if (!healthy) fmt::print(stderr, "legwright: warning: {}\n", terminal_text(facts.standing));
  if (options.json)
    fmt::print("{}", to_text({{"schema", "legwright/export"},
                              {"version", 1},
                              {"run", options.run},
                              {"folder", target.string()},
                              {"robot", name + ".xml"},
                              {"files", files},
                              {"verdicts", facts.verdicts},
                              {"home_touches", touches.size()},
                              {"urdf_lost", facts.urdf_lost},
                              {"engine_warnings", stood.warnings.size()}}));
  else
    tell_people(facts, target, files.size());
  return healthy ? kOk : kInfeasible;
}

}  // namespace

void add_export(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "export",
               "Put the robot of a run into a folder of its own, for stock MuJoCo", export_run);
  verb->add_option("RUN", options->run, "Folder that legwright optimize wrote")->required();
  verb->add_option("-o,--output", options->output,
                   "new folder, which must not exist; default: exports/RUN");
  verb->add_flag("--no-picture", options->no_picture, "leave the picture out");
  verb->add_flag("--urdf", options->urdf,
                 "also urdf/NAME.urdf with its meshes; tells what it lacks");
  verb->add_flag("--ros", options->ros, "also ros/PACKAGE, a ROS 2 package with URDF and gait");
  verb->add_flag("--json", options->json, "print one JSON document");
  verb->footer(
      "Writes, whole or not at all: NAME.xml (the robot, byte for byte as in result/), scene.xml "
      "(it on a floor; no plugin),\n"
      "the gait (walk.xml, plugin_walk.xml, gait.csv, gains.json; of several tasks TASK_walk.xml "
      "...) with play.py, which\n"
      "walks it without the plugin, NAME.png, README.md (where it comes from, what changed, what "
      "physics says, what the "
      "files are), and the\n"
      "licence that stood beside the robot's file. The scene is opened, compared with the robot, "
      "and simulated for 1 s.\n"
      "--urdf: each body is a link at the anchor of its joint, one with several hinges a chain of "
      "links; refused where a joint is a ball.\n"
      "Exit code: 0; 1 where that second brought a warning of MuJoCo; 3 where the folder exists or "
      "the run has no result.");
}

}  // namespace legwright
