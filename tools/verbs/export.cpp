// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <set>
#include <stdexcept>

#include "mjcf/propose/home_touches.hpp"
#include "mjcf/scene/plain_scene.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/text/robot_files.hpp"
#include "mjcf/text/safe_path.hpp"
#include "mjcf/write/verify.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/clean_text.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/files/licence.hpp"
#include "tools/files/unfinished_folder.hpp"
#include "tools/render/gl_context.hpp"
#include "tools/render/portrait.hpp"
#include "tools/run/export_readme.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/task_folders.hpp"
#include "tools/simulate/stand.hpp"
#include "tools/verbs/summary.hpp"
#include "tools/verbs/verbs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  std::string run, output;
  bool no_picture = false, json = false;
};

/// What stands at a path in a JSON document; null where there is nothing.
Json value_in(const Json& document, std::initializer_list<const char*> path) {
  const Json* at = &document;
  for (const char* const key : path) {
    if (!at->is_object() || !at->contains(key)) return {};
    at = &at->at(key);
  }
  return *at;
}

/// A text in a JSON document that others may have written; empty where there is none.
std::string text_in(const Json& document, std::initializer_list<const char*> path) {
  const Json value = value_in(document, path);
  return value.is_string() ? value.get<std::string>() : std::string();
}

/// The last part of an absolute path: what is passed on tells nothing of its author's folders.
std::string without_folders(const std::string& word) {
  return fs::path(word).is_absolute() ? fs::path(word).filename().string() : word;
}

std::string command_of(const Json& run) {
  std::string out;
  if (run.is_object() && run.contains("argv") && run["argv"].is_array())
    for (const Json& word : run["argv"])
      if (word.is_string())
        out += (out.empty() ? "legwright"
                            : " " + shell_word(without_folders(word.get<std::string>())));
  return out;
}

/// A file that run.json knows by another SHA-256; one that it does not know passes.
void check_sum(const Json& run, const std::string& name, const std::string& bytes,
               const fs::path& file) {
  const std::string wanted = text_in(run, {"sha256", name.c_str()});
  if (!wanted.empty() && wanted != sha256_hex(bytes))
    throw InputError(file.string(), 0, "",
                     "is not what the run started from (its SHA-256 in run.json is another); run "
                     "`legwright optimize` again");
}

void check_assets(const Json& run, const RobotFiles& files) {
  for (const AssetFile& asset : files.assets())
    check_sum(run, asset.path.generic_string(), read_regular_file(asset.source, asset.bytes),
              asset.source);
}

/// All files of the robot that the run started from.
void check_sums(const Json& run, const RobotFiles& files) {
  check_sum(run, "robot.xml", files.main_text(), files.file());
  for (const IncludedFile& part : files.includes())
    check_sum(run, part.path.generic_string(), part.text, files.folder() / part.path);
  check_assets(run, files);
}

/// The robot of a run, before and after.
struct ExportedRun {
  Json run;
  RobotModel before, after;
};

ExportedRun read_run(const fs::path& root) {
  const ResultFolder folder = ResultFolder::open(root);
  ExportedRun out;
  out.run = read_json(folder.run_json());
  const fs::path input = folder.inputs() / "robot.xml", result = folder.result() / "robot.xml";
  if (!fs::exists(result))
    throw IoError(result.string() +
                  ": no such file; the run has no result yet, finish `legwright " + "optimize`");
  out.before = read_robot(input);
  check_sums(out.run, out.before.files);
  // What was a leg is one: a design may be read otherwise where it is borderline.
  const RobotFiles files = RobotFiles::read(result);
  check_assets(out.run, files);
  out.after = files.at_their_lines([&] { return parse_robot(files, &out.before.structure); });
  const Eigen::VectorXd s = out.after.space.initial();
  const std::string difference =
      s.size() != out.before.space.size()
          ? "other design parameters"
          : find_difference(out.before.morphology, s, out.after.morphology, s);
  if (!difference.empty())
    throw InputError(result.string(), 0, "",
                     "is not the robot of inputs/ at the design that it declares (" + difference +
                         "); run `legwright optimize` again");
  return out;
}

/// One line for each task that was validated.
std::vector<std::string> verdicts_of(const fs::path& root) {
  std::vector<std::string> lines;
  std::vector<fs::path> folders{root};
  for (const TaskFolder& task : task_folders_of(root)) folders.push_back(root / task.relative);
  for (const fs::path& folder : folders) {
    const fs::path file = folder / "result" / "verdict.json";
    if (!fs::exists(file)) continue;
    const std::string line = text_in(read_json(file), {"result", "line"});
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

double friction_of(const Json& run) {
  const auto at = [](const Json& task) {
    if (!task.is_object() || !task.contains("floor_friction")) return 1.0;
    const Json& value = task["floor_friction"];
    const double number = value.is_number() ? value.get<double>() : 1.0;
    return number > 0.0 && number <= 100.0 ? number : 1.0;
  };
  if (run.is_object() && run.contains("task")) return at(run["task"]);
  if (run.is_object() && run.contains("tasks") && run["tasks"].is_array() && !run["tasks"].empty())
    return at(run["tasks"].front());
  return 1.0;
}

std::string describe(const StandingResult& stand) {
  std::string out = fmt::format(
      "Left to stand on the floor of `scene.xml` for {:.3g} s in its home pose: ", stand.seconds);
  if (stand.warnings.empty()) out += "no warning of the engine";
  for (std::size_t k = 0; k < stand.warnings.size(); ++k)
    out += fmt::format("{}{} ({} times, first at {:.3g} s)", k ? ", " : "", stand.warnings[k].text,
                       stand.warnings[k].count, stand.warnings[k].time);
  if (std::isfinite(stand.trunk_after))
    out += fmt::format("; its trunk went from {:.3f} to {:.3f} m", stand.trunk_before,
                       stand.trunk_after);
  return out + ".";
}

/// A name for the main file that none of the robot's other files has.
std::string free_name(std::string name, const RobotFiles& files) {
  std::set<std::string> taken;  // at the top of the folder, files and folders
  for (const IncludedFile& part : files.includes()) taken.insert(part.path.begin()->string());
  for (const AssetFile& asset : files.assets()) taken.insert(asset.path.begin()->string());
  while (taken.count(name + ".xml") > 0) name += "_robot";
  return name;
}

/// The robot's files as they are, the main one under `name`. @return all but that
std::vector<std::string> write_robot(const RobotFiles& files, const fs::path& folder,
                                     const std::string& name) {
  std::vector<std::string> others;
  const auto place = [&](const fs::path& path) {
    if (fs::exists(folder / path) || path == "scene.xml" || path == "README.md")
      throw InputError(files.file().string(), 0, path.generic_string(),
                       "this name is needed in the exported folder; rename the file");
    fs::create_directories((folder / path).parent_path());
    others.push_back(path.generic_string());
    return folder / path;
  };
  write_file(folder / name, files.main_text());
  for (const IncludedFile& part : files.includes()) write_file(place(part.path), part.text);
  for (const AssetFile& asset : files.assets()) {
    // Not linked: who edits the export must not change the run.
    write_file(place(asset.path), read_regular_file(asset.source, asset.bytes));
  }
  return others;
}

ExportFacts facts_of(const ExportedRun& from, const fs::path& root, const std::string& name) {
  ExportFacts facts;
  facts.name = name;
  facts.model = from.after.morphology.name;
  facts.robot_file = without_folders(text_in(from.run, {"files", "robot.xml"}));
  facts.robot_sha256 = sha256_hex(from.before.files.main_text());
  facts.task_file = without_folders(text_in(from.run, {"files", "task.toml"}));
  facts.task_sha256 = text_in(from.run, {"sha256", "task.toml"});
  facts.version = text_in(from.run, {"versions", "legwright"});
  facts.engine = text_in(from.run, {"versions", "mujoco"});
  facts.command = command_of(from.run);
  facts.status = text_in(from.run, {"status"});
  for (int k = 0; k < from.before.space.size(); ++k) {
    const DesignParameter& p = from.before.space.parameters[k];
    facts.parameters.push_back(
        {p.name, p.unit, p.sentence, p.initial, from.after.space.parameters[k].initial});
  }
  facts.mass_before = from.before.morphology.total_mass();
  facts.mass_after = from.after.morphology.total_mass();
  facts.verdicts = verdicts_of(root);
  if (const Json kp = value_in(from.run, {"task", "servo_kp_Nm_per_rad"}); kp.is_number())
    facts.servo_kp = kp.get<double>();
  return facts;
}

std::vector<HomeTouch> home_touches(const ExportedRun& run) {
  return new_home_touches(*compile_mjcf(run.before.xml, run.before.file),
                          *compile_mjcf(run.after.xml, run.after.file), run.after.file);
}

/// Draws it, or says why not: a machine without OpenGL exports all the same.
std::string draw(const fs::path& scene, const std::string& png, std::string& left_out) {
  try {
    pin_rasteriser();
    draw_portrait(scene, scene.parent_path() / png);
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

int export_run(const ExportOptions& options) {
  const fs::path target = target_of(options);
  const ExportedRun from = read_run(options.run);
  std::string name = plain_name(from.after.morphology.name);
  if (name.empty()) name = "robot";
  if (name == "scene") name = "scene_robot";
  name = free_name(std::move(name), from.after.files);
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
  facts.others = others;
  const std::vector<HomeTouch> touches = home_touches(from);
  facts.touches = describe(touches);
  std::string left_out;
  std::string picture = name + ".png";
  while (fs::exists(folder.path() / picture)) picture.insert(0, "picture_of_");  // a texture's
  if (!options.no_picture) facts.picture = draw(scene, picture, left_out);
  facts.licences = copy_licences(ResultFolder::open(options.run).inputs(), folder.path());
  write_file(folder.path() / "README.md", export_readme(facts));
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
    if (entry.is_regular_file())
      files.push_back(fs::relative(entry.path(), folder.path()).generic_string());
  std::sort(files.begin(), files.end());
  folder.appear();

  const bool healthy = stood.warnings.empty() && !stood.diverged;
  if (!left_out.empty()) fmt::print(stderr, "legwright: warning: no picture: {}\n", left_out);
  if (!touches.empty())
    fmt::print(stderr, "legwright: warning: {}\n", terminal_text(facts.touches));
  if (!healthy) fmt::print(stderr, "legwright: warning: {}\n", terminal_text(facts.standing));
  if (options.json) {
    fmt::print("{}", to_text({{"schema", "legwright/export"},
                              {"version", 1},
                              {"run", options.run},
                              {"folder", target.string()},
                              {"robot", name + ".xml"},
                              {"files", files},
                              {"verdicts", facts.verdicts},
                              {"home_touches", touches.size()},
                              {"engine_warnings", stood.warnings.size()}}));
  } else {
    fmt::print("{}\n", terminal_text(facts.standing));
    fmt::print("written  {}: {} files\nnext: python -m mujoco.viewer --mjcf={}\n",
               shell_word(target.string()), files.size(),
               shell_word((target / "scene.xml").string()));
  }
  return healthy ? kOk : kInfeasible;
}

}  // namespace

void add_export(CLI::App& program, Action& action) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* verb = program.add_subcommand(
      "export", "Put the robot of a run into a folder of its own, for stock MuJoCo");
  verb->add_option("RUN", options->run, "Folder that legwright optimize wrote")->required();
  verb->add_option("-o,--output", options->output,
                   "new folder, which must not exist; default: exports/RUN");
  verb->add_flag("--no-picture", options->no_picture, "leave the picture out");
  verb->add_flag("--json", options->json, "print one JSON document");
  verb->footer(
      "Writes, whole or not at all: NAME.xml (the robot, byte for byte as in result/), scene.xml "
      "(it on a floor; no plugin),\n"
      "NAME.png, README.md (where it comes from, what changed, what physics says), and the licence "
      "that stood beside\n"
      "the robot's file. The scene is opened, compared with the robot, and simulated for 1 s.\n"
      "Exit code: 0; 1 where that second brought a warning of MuJoCo; 3 where the folder exists or "
      "the run has no result.");
  verb->callback([&action, options] { action = [options] { return export_run(*options); }; });
}

}  // namespace legwright
