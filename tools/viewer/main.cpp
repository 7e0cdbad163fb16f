// SPDX-License-Identifier: Apache-2.0
// legwright-viewer: MuJoCo's viewer for gaits. `legwright play` calls it.
#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>

#include "tools/files/clean_text.hpp"
#include "tools/files/exit_code.hpp"
#include "tools/run/install.hpp"
#include "tools/simulate/mujoco_host.hpp"
#include "tools/viewer/message_lines.hpp"
#include "tools/viewer/viewer.hpp"

namespace {

/// Scenes, histories and frame buffers are blocks of megabytes that come and go with every design.
/// glibc would take to putting such blocks on its heap after the first was freed, where a small one
/// behind them keeps them from going back to the system.
void keep_big_blocks_off_the_heap() { ::mallopt(M_MMAP_THRESHOLD, 1 << 18); }

/// Messages may hold names from files: none of them shall command the terminal.
void print_line(std::FILE* to, const std::string& text) {
  fmt::print(to, "{}\n", legwright::terminal_text(text));
  std::fflush(to);
}

int complain(const std::string& message, int code) {
  print_line(stderr, "legwright-viewer: " + message);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  keep_big_blocks_off_the_heap();
  CLI::App program{"Shows a gait in MuJoCo's viewer, from its first pose.", "legwright-viewer"};
  program.set_version_flag("--version", legwright::program_version());
  legwright::ViewerOptions options;
  program.add_option("SCENE", options.path, "scene.xml, or with --live the folder of a run")
      ->required();
  program.add_flag("--live", options.follow,
                   "follow a run: show each design as it lands, at last the result");
  program.add_flag("--paused", options.paused, "wait in the first pose; Space lets it go");
  program.add_flag("--ghost", options.ghost, "show the planned robot as well; key 5 does it later");
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? legwright::kOk : legwright::kBadInput;
  }
  options.say = [](const std::string& text) { print_line(stdout, text); };
  if (!options.follow && !std::filesystem::is_regular_file(options.path))
    return complain(options.path.string() + ": no such file", legwright::kIoError);
  try {
    legwright::view(options);
  } catch (const legwright::IoError& error) {
    return complain(error.what(), legwright::kIoError);
  } catch (const legwright::MujocoError& error) {
    return complain(std::string(error.what()) +
                        "; it needs a display with OpenGL (`legwright render` draws without one)",
                    legwright::kIoError);
  } catch (const std::exception& error) {
    return complain(std::string("internal error: ") + error.what(), legwright::kInternal);
  }
  return legwright::kOk;
}
