// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdlib>

#include "mjcf/text/input_error.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/files/shell_word.hpp"
#include "tools/run/install.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/task_folders.hpp"
#include "tools/simulate/plugin_files.hpp"
#include "tools/verbs/number_options.hpp"
#include "tools/verbs/verbs.hpp"
#include "tools/verbs/viewer_programs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct PlayOptions : ReadingOptions {
  std::string run;
  std::string viewer;  // one of kViewers; empty: the best that is there
  int iteration = -1;
  bool live = false, print = false, json = false;
};

const std::vector<std::string> kViewers{"legwright", "simulate", "python"};

/// A joint run has a gait for each task, and nothing to play by itself.
void refuse_joint_run(const fs::path& root, const std::string& options) {
  std::string choices;
  for (const TaskFolder& task : task_folders_of(root))
    choices += "\n  legwright play " + options + shell_word((root / task.relative).string());
  if (!choices.empty())
    throw InputError(root.string() +
                     ": a joint run has a gait for each task; play one of them:" + choices);
}

fs::path scene_to_play(const PlayOptions& options) {
  const ResultFolder folder = ResultFolder::open(options.run);
  options.check_run(options.run);
  refuse_joint_run(options.run, "");
  const fs::path design =
      options.iteration >= 0 ? folder.iteration(options.iteration) : folder.result();
  const fs::path scene = design / "scene.xml";
  if (!fs::is_regular_file(scene))
    throw IoError(scene.string() + ": no such file; " +
                  (options.iteration >= 0
                       ? "give an iteration that " + folder.iterations().string() + " holds"
                       : "the run has no result yet; follow it with --live, or try --iteration 0"));
  return fs::absolute(scene);
}

std::string as_shell(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

/// The folder of a run to follow; it need not exist yet.
fs::path run_to_follow(const PlayOptions& options) {
  if (fs::exists(fs::path(options.run) / "run.json")) refuse_joint_run(options.run, "--live ");
  if (fs::exists(options.run) && !fs::is_directory(options.run))
    throw IoError(options.run + ": is a file; --live follows the folder of a run");
  return fs::absolute(options.run);
}

[[noreturn]] void refuse_without(const std::string& program, const std::string& otherwise) {
  throw IoError(fmt::format("{} was not found beside {}; {}{}", program, program_file().string(),
                            viewer_cure(), otherwise));
}

/// Which viewer to open. Throws IoError, with the way to get it, where that one is not there.
std::string choose_viewer(const PlayOptions& options) {
  const bool legwright = find_beside(kViewerProgram).has_value();
  const bool simulate = find_beside(kSimulateProgram).has_value();
  const std::string best = legwright ? "legwright" : simulate ? "simulate" : "python";
  std::string chosen = !options.viewer.empty() ? options.viewer : options.live ? "legwright" : best;
  if (options.live && chosen != "legwright")
    throw InputError("--live needs Legwright's own viewer, not --viewer " + chosen);
  if ((chosen == "legwright" && !legwright) || (chosen == "simulate" && !simulate))
    refuse_without(chosen == "simulate" ? kSimulateProgram : kViewerProgram,
                   options.live || is_packaged() ? "" : ", or use --viewer python");
  // Python is what is left, and only where it has MuJoCo; else the missing viewer is the fault.
  const bool only_told = options.print || options.json;
  if (options.viewer.empty() && chosen == "python" && !only_told && !find_viewer_python())
    refuse_without(
        kViewerProgram,
        is_packaged() ? "" : "; or " + viewer_python_cure() + " and use --viewer python");
  return chosen;
}

/// The plugin for the MuJoCo of that Python.
fs::path plugin_for(const std::optional<ViewerPython>& python) {
  if (!python)
    throw IoError("no Python with MuJoCo's viewer was found; " + viewer_python_cure() +
                  " and name its interpreter in LEGWRIGHT_PYTHON, or use --print and run the "
                  "command yourself");
  try {
    return fs::absolute(require_plugin(python->mujoco_version));
  } catch (const PluginError& error) {
    throw PluginError(fmt::format("{} has mujoco {}: {}\nOr give it the MuJoCo of this program: {}",
                                  python->command, python->mujoco_version, error.what(),
                                  viewer_python_cure()));
  }
}

void require_display() {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY"))
    throw IoError(
        "no display: neither DISPLAY nor WAYLAND_DISPLAY is set; `legwright render` draws without "
        "one");
}

const char* hint_for(const std::string& viewer) {
  if (viewer == "legwright")
    return "Keys: Space pauses, Backspace starts the gait anew, Tab hides the panel, F1 lists "
           "all.\n"
           "The plan: 5 its ghost, M its centre of mass, C its footholds, F its forces.";
  if (viewer == "simulate")
    return "simulate drops the robot with all joints at zero. To see it walk, set Simulation > Key "
           "to 1 and press Load key.";
  return "In the viewer, Simulation > Load key puts the robot at the start of its gait.";
}

/// What opens the window, and the plugin that comes into it.
struct OpenedViewer {
  fs::path plugin;
  std::vector<std::string> command;
};

/// The plugin for the MuJoCo of this program and its viewers.
fs::path own_plugin() { return fs::absolute(require_plugin(versions()["mujoco"])); }

OpenedViewer open_by(const std::string& viewer, const PlayOptions& options, const fs::path& path) {
  // Looking for Python takes a second: not where only the command is wanted.
  if (viewer == "python" && !options.print && !options.json) {
    const auto python = find_viewer_python();
    const fs::path plugin = plugin_for(python);
    return {plugin, viewer_command(python->command, plugin, path)};
  }
  const fs::path plugin = own_plugin();
  if (viewer == "python") return {plugin, viewer_command("python3", plugin, path)};
  std::vector<std::string> command{
      find_beside(viewer == "simulate" ? kSimulateProgram : kViewerProgram)->string()};
  if (options.live) command.emplace_back("--live");
  command.push_back(path.string());
  return {plugin, command};
}

int play(const PlayOptions& options) {
  const fs::path path = options.live ? run_to_follow(options) : scene_to_play(options);
  if (options.viewer != "python") own_plugin();  // without which no viewer is of use
  const std::string viewer = choose_viewer(options);
  const auto [plugin, command] = open_by(viewer, options, path);
  if (options.json) {
    fmt::print("{}", to_text({{"schema", "legwright/play"},
                              {"version", 1},
                              {"viewer", viewer},
                              {options.live ? "run" : "scene", path.string()},
                              {"plugin", plugin.string()},
                              {"command", command}}));
    return kOk;
  }
  fmt::print("{}\n", as_shell(command));
  std::fflush(stdout);
  if (options.print) return kOk;
  require_display();
  fmt::print(stderr, "{}\n", hint_for(viewer));
  if (run_command(command) != 0)
    throw IoError("the viewer ended with an error; its own message stands above");
  return kOk;
}

}  // namespace

void add_play(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "play",
               "Open a result in MuJoCo's viewer, or follow a run; print the plain command", play);
  verb->add_option("RUN", options->run, "folder of a run")->required();
  CLI::Option* iteration = verb->add_option("--iteration", options->iteration,
                                            "play this iteration instead of the result")
                               ->check(number_from_zero());
  verb->add_flag("--live", options->live,
                 "follow a run that goes on or is yet to start: show each design as it lands")
      ->excludes(iteration);
  verb->add_option("--viewer", options->viewer,
                   "legwright (starts in the gait; default), simulate (MuJoCo's own), python "
                   "(mujoco.viewer)")
      ->check(CLI::IsMember(kViewers));
  verb->add_flag("--print", options->print, "only print the command");
  verb->add_flag("--json", options->json, "only print scene, plugin and command as JSON");
}

}  // namespace legwright
