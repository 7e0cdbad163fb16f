// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "mjcf/input_error.hpp"
#include "tools/io/install.hpp"
#include "tools/io/io_error.hpp"
#include "tools/io/json_file.hpp"
#include "tools/io/result_folder.hpp"
#include "tools/io/task_folders.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/verbs/summary.hpp"
#include "tools/verbs/verbs.hpp"
#include "tools/verbs/viewer.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct PlayOptions {
  std::string run;
  int iteration = -1;
  bool print = false, json = false;
};

/// A joint run has a gait for each task, and nothing to play by itself.
void refuse_joint_run(const fs::path& root) {
  std::string choices;
  for (const TaskFolder& task : task_folders_of(root))
    choices += "\n  legwright play " + shell_word((root / task.relative).string());
  if (!choices.empty())
    throw InputError(root.string() +
                     ": a joint run has a gait for each task; play one of them:" + choices);
}

fs::path scene_to_play(const PlayOptions& options) {
  const ResultFolder folder = ResultFolder::open(options.run);
  refuse_joint_run(options.run);
  const fs::path design =
      options.iteration >= 0 ? folder.iteration(options.iteration) : folder.result();
  const fs::path scene = design / "scene.xml";
  if (!fs::is_regular_file(scene))
    throw IoError(scene.string() + ": no such file; " +
                  (options.iteration >= 0
                       ? "give an iteration that " + folder.iterations().string() + " holds"
                       : "the run has no result yet, try --iteration 0"));
  return fs::absolute(scene);
}

fs::path plugin_to_load() {
  if (const auto plugin = find_plugin()) return fs::absolute(*plugin);
  std::string places;
  for (const fs::path& candidate : plugin_candidates()) places += "\n  " + candidate.string();
  throw IoError(
      "the plugin liblegwright.so was not found; build it, or name it in LEGWRIGHT_PLUGIN. Looked "
      "for:" +
      places);
}

std::string as_shell(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

void require_viewer(const std::optional<ViewerPython>& python) {
  const std::string wanted = versions()["mujoco"];
  if (!python)
    throw IoError("no Python with MuJoCo's viewer was found; pip install mujoco==" + wanted +
                  " and name its interpreter in LEGWRIGHT_PYTHON, or use --print and run the "
                  "command yourself");
  if (python->mujoco_version != wanted)
    throw IoError(fmt::format("{} has mujoco {}, the plugin is for {}; pip install mujoco=={}",
                              python->command, python->mujoco_version, wanted, wanted));
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY"))
    throw IoError(
        "no display: neither DISPLAY nor WAYLAND_DISPLAY is set; `legwright render` draws without "
        "one");
}

int play(const PlayOptions& options) {
  const fs::path scene = scene_to_play(options);
  const fs::path plugin = plugin_to_load();
  // Looking for Python takes a second: not where only the command is wanted.
  const auto python = options.print || options.json ? std::nullopt : find_viewer_python();
  const std::vector<std::string> command =
      viewer_command(python ? python->command : "python3", plugin, scene);
  if (options.json) {
    fmt::print("{}", to_text({{"schema", "legwright/play"},
                              {"version", 1},
                              {"scene", scene.string()},
                              {"plugin", plugin.string()},
                              {"command", command}}));
    return kOk;
  }
  fmt::print("{}\n", as_shell(command));
  std::fflush(stdout);
  if (options.print) return kOk;
  require_viewer(python);
  fmt::print(stderr,
             "In the viewer, Simulation > Load key puts the robot at the start of its gait.\n");
  if (run_command(command) != 0)
    throw IoError("the viewer ended with an error; its own message stands above");
  return kOk;
}

}  // namespace

void add_play(CLI::App& program, Action& action) {
  const auto options = std::make_shared<PlayOptions>();
  CLI::App* verb =
      program.add_subcommand("play", "Open a result in MuJoCo's viewer; print the plain command");
  verb->add_option("RUN", options->run, "folder of a run")->required();
  verb->add_option("--iteration", options->iteration, "play this iteration instead of the result")
      ->check(CLI::NonNegativeNumber);
  verb->add_flag("--print", options->print, "only print the command");
  verb->add_flag("--json", options->json, "only print scene, plugin and command as JSON");
  verb->callback([&action, options] { action = [options] { return play(*options); }; });
}

}  // namespace legwright
