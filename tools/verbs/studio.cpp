// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/studio_service.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <thread>
#include <vector>

#include "tools/files/clean_text.hpp"
#include "tools/run/install.hpp"
#include "tools/studio/server.hpp"
#include "tools/verbs/save_session.hpp"
#include "tools/verbs/stop_signals.hpp"
#include "tools/verbs/verbs.hpp"
#include "tools/verbs/viewer_programs.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

struct StudioVerbOptions {
  std::string path;
  std::vector<std::string> roots, library;
  int port = 0;
  bool no_browser = false;
};

/// Examples of a build tree or of an installed program.
fs::path examples_folder() {
  if (const char* own = std::getenv("LEGWRIGHT_EXAMPLES"); own && *own) return own;
  const fs::path beside = program_file().parent_path().parent_path();
  for (const fs::path& folder :
       {beside / "share" / "legwright" / "examples", beside.parent_path() / "examples"})
    if (fs::is_regular_file(folder / "puppy" / "robot.xml")) return folder;
  return {};
}

/// Folders that were named; else the working directory. What is opened may be read and written
/// beside.
std::vector<fs::path> roots_of(const StudioVerbOptions& options) {
  std::vector<fs::path> roots(options.roots.begin(), options.roots.end());
  if (roots.empty()) roots.push_back(fs::current_path());
  if (options.path.empty()) return roots;
  const fs::path opened = fs::weakly_canonical(fs::absolute(options.path));
  roots.push_back(opened.parent_path());
  return roots;
}

void open_browser(const std::string& url) {
  const bool display = std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY");
  if (!display) return;
  std::thread([url] {  // it may go on as long as the browser does
    std::string ignored;
    (void)run_command({"xdg-open", url}, &ignored);
  })
      .detach();
}

void save_from_studio(const SessionRecord& record, const std::filesystem::path& run, bool force,
                      const SavedFrom& from) {
  save_session(
      record, run, force,
      {{"legwright", "studio", from.origin.string()}, "designed in the Studio", from.robot});
}

int studio(const StudioVerbOptions& options) {
  const StopSignals signals;
  StudioService studio({roots_of(options), studio_state_folder(), examples_folder(), program_file(),
                        save_from_studio, options.library});
  if (!options.path.empty()) studio.open(fs::absolute(options.path).string());
  StudioServer server(studio, options.port);
  fmt::print("{}\n", server.url());
  std::fflush(stdout);
  fmt::print(stderr, "The studio runs until Ctrl-C; the address holds for this browser alone.\n");
  if (!options.no_browser) open_browser(server.url());
  while (!StopSignals::asked()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  return kOk;
}

}  // namespace

void add_studio(CLI::App& program, Action& action) {
  const auto [verb, options] =
      add_verb(program, action, "studio",
               "Design body and gait by hand and by search, in a browser", studio);
  verb->add_option(
      "PATH", options->path,
      "MJCF of a robot, a task file, an assembly, or the folder of a run; without it a page to "
      "start from");
  verb->add_option("--port", options->port, "of 127.0.0.1; default: one that is free")
      ->check(CLI::Range(1, 65535));
  verb->add_option("--roots", options->roots,
                   "a folder below which the page may read and write, besides that of PATH; may be "
                   "given several times; default: the working directory")
      ->allow_extra_args(false);
  verb->add_option("--library", options->library,
                   "a folder of modules of your own (*.toml); may be given several times")
      ->allow_extra_args(false);
  verb->add_flag("--no-browser", options->no_browser, "only print the address");
  verb->footer(
      "Prints an address of this machine and opens it where there is a display. Nobody else is let "
      "in; from afar: ssh -L PORT:127.0.0.1:PORT HOST\n"
      "What is done is kept as it goes in $XDG_STATE_HOME/legwright/studio: a studio that was "
      "killed goes on where it was, legwright studio RUN with that run.");
}

}  // namespace legwright
