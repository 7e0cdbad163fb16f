// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/python_module.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "tools/files/io_error.hpp"
#include "tools/verbs/viewer_programs.hpp"

namespace legwright {
namespace {

// Finds the module without running it; where that fails, prints why.
constexpr const char* kProbe =
    "import importlib.util, sys\n"
    "try: found = importlib.util.find_spec(sys.argv[1])\n"
    "except BaseException as error: sys.exit(print(error) or 1)\n"
    "sys.exit(0 if found else print('No module named ' + repr(sys.argv[1])) or 1)\n";

std::string chosen_interpreter() {
  const char* own = std::getenv("LEGWRIGHT_PYTHON");
  return own && *own ? own : "python3";
}

/// Throws IoError where this interpreter cannot run the module.
void require_module(const std::string& python, const std::string& module,
                    const std::string& extra) {
  const std::string cure = fmt::format(
      "pip install \".[{}]\" in a clone of Legwright, and name the interpreter that has it in "
      "LEGWRIGHT_PYTHON",
      extra);
  std::string said;
  const int code = run_command({python, "-c", kProbe, module}, &said);
  if (code == 0) return;
  if (code < 0)
    throw IoError(
        fmt::format("{}: this Python does not run, and {} is a part of Legwright in "
                    "Python: {}",
                    python, module, cure));
  while (!said.empty() && said.back() == '\n') said.pop_back();
  throw IoError(fmt::format("{} has no {} ({}): {}", python, module, said, cure));
}

volatile sig_atomic_t started_child = 0;

/// What a terminal sends reaches the child by itself.
void pass_on(int signal, siginfo_t* about, void*) {
  if (started_child > 0 && about->si_code != SI_KERNEL) ::kill(started_child, signal);
}

/// While one lives, signals that ask to stop go to the child and leave this process alone.
class PassedSignals {
 public:
  explicit PassedSignals(pid_t child) {
    started_child = child;
    struct sigaction action {};
    action.sa_sigaction = pass_on;
    action.sa_flags = SA_RESTART | SA_SIGINFO;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &action, &before_[i]);
  }
  ~PassedSignals() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
    started_child = 0;
  }
  PassedSignals(const PassedSignals&) = delete;
  PassedSignals& operator=(const PassedSignals&) = delete;

 private:
  static constexpr std::array<int, 4> kSignals{SIGINT, SIGTERM, SIGHUP, SIGUSR1};
  std::array<struct sigaction, kSignals.size()> before_;
};

}  // namespace

int run_python_module(const std::string& module, const std::string& extra,
                      const std::vector<std::string>& arguments) {
  const std::string python = chosen_interpreter();
  require_module(python, module, extra);
  std::vector<std::string> words{python, "-m", module};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  const PassedSignals passed(child);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  throw std::runtime_error(
      fmt::format("{} -m {} was ended by signal {}", python, module, WTERMSIG(status)));
}

}  // namespace legwright
