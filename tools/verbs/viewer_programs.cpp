// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/viewer_programs.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "tools/run/install.hpp"

namespace legwright {
namespace {

// Exit code of the child where the program to run does not exist, as shells have it.
constexpr int kNotFound = 127;

std::string python_text(const std::string& text) {
  std::string quoted = "'";
  for (char c : text) quoted += (c == '\'' || c == '\\') ? std::string{'\\', c} : std::string(1, c);
  return quoted + "'";
}

[[noreturn]] void run_child(const std::vector<std::string>& words, int output) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  if (output >= 0) {
    const int nothing = ::open("/dev/null", O_RDWR);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(nothing, STDERR_FILENO);
  }
  ::execvp(argv[0], argv.data());
  ::_exit(kNotFound);
}

}  // namespace

int run_command(const std::vector<std::string>& words, std::string* output) {
  int ends[2] = {-1, -1};
  if (output && ::pipe2(ends, O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) run_child(words, ends[1]);
  if (output) {
    ::close(ends[1]);
    char buffer[4096];
    for (ssize_t got;
         (got = ::read(ends[0], buffer, sizeof buffer)) > 0 || (got < 0 && errno == EINTR);)
      if (got > 0) output->append(buffer, static_cast<std::size_t>(got));
    ::close(ends[0]);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status)) return -1;
  return WEXITSTATUS(status) == kNotFound ? -1 : WEXITSTATUS(status);
}

std::optional<ViewerPython> find_viewer_python() {
  std::vector<std::string> candidates{"python3", "python"};
  if (const char* own = std::getenv("LEGWRIGHT_PYTHON"); own && *own) candidates = {own};
  for (const std::string& candidate : candidates) {
    std::string version;
    if (run_command({candidate, "-c", "import mujoco, mujoco.viewer; print(mujoco.__version__)"},
                    &version) != 0)
      continue;
    while (!version.empty() && version.back() == '\n') version.pop_back();
    return ViewerPython{candidate, version};
  }
  return std::nullopt;
}

std::vector<std::string> viewer_command(const std::string& python,
                                        const std::filesystem::path& plugin,
                                        const std::filesystem::path& scene) {
  const std::string script = fmt::format(
      "import mujoco, mujoco.viewer; mujoco.mj_loadPluginLibrary({}); "
      "m = mujoco.MjModel.from_xml_path({}); d = mujoco.MjData(m); "
      "mujoco.mj_resetDataKeyframe(m, d, m.key('gait').id); mujoco.viewer.launch(m, d)",
      python_text(plugin.string()), python_text(scene.string()));
  return {python, "-c", script};
}

std::optional<std::filesystem::path> find_beside(const std::string& program) {
  const std::filesystem::path file = program_file().parent_path() / program;
  if (::access(file.c_str(), X_OK) == 0) return file;
  return std::nullopt;
}

std::string viewer_python_cure() { return "pip install '" LEGWRIGHT_PYTHON_VIEWER "'"; }

bool is_packaged() {
  return std::filesystem::exists(program_file().parent_path().parent_path() / "__init__.py");
}

std::string viewer_cure() {
  if (!is_packaged()) return LEGWRIGHT_VIEWER_CURE;
  return "the Python package has none of its own; " + viewer_python_cure() +
         " for `legwright play --viewer python` (which has no --live)";
}

}  // namespace legwright
