// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/python_module.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include "tools/files/io_error.hpp"
#include "tools/run/install.hpp"
#include "tools/verbs/handled_signals.hpp"
#include "tools/verbs/parent_death.hpp"
#include "tools/verbs/viewer_programs.hpp"

namespace legwright {
namespace {

// Prints the version of the package, then whether the libraries are there, without loading them.
constexpr const char* kProbe =
    "import importlib.util, sys, legwright\n"
    "lacks = [name for name in sys.argv[1:] if not importlib.util.find_spec(name)]\n"
    "print(legwright.__version__, f'lacks {\", \".join(lacks)}' if lacks else 'has', end='')\n";

std::vector<std::string> candidates() {
  if (const char* own = std::getenv("LEGWRIGHT_PYTHON"); own && *own) return {own};
  return {"python3", "python"};
}

/// What an interpreter lacks; empty where it can run the part.
std::string lack_of(const std::string& python, const PythonPart& part) {
  std::string found;
  // -P: what lies in the working directory is no package.
  std::vector<std::string> words{python, "-P", "-c", kProbe};
  words.insert(words.end(), part.libraries.begin(), part.libraries.end());
  const int code = run_command(words, &found);
  if (code < 0) return "does not run";
  if (code != 0 || found.empty()) return "has no package legwright";
  if (found == program_version() + " has") return "";
  const std::string lacks = program_version() + " lacks ";
  if (found.starts_with(lacks)) return "has legwright, but not " + found.substr(lacks.size());
  return fmt::format("has legwright {}, and this program is {}", found.substr(0, found.find(' ')),
                     program_version());
}

/// Throws IoError with what is wrong of each that was tried.
std::string find_python(const PythonPart& part) {
  const PythonFound found = look_for_python(part);
  if (!found.python.empty()) return found.python;
  throw IoError(fmt::format("{} runs in Python, and there is none for it: {}. Install it with {}",
                            part.module, found.lacks, python_cure(part)));
}

volatile sig_atomic_t started_child = 0;

/// What a terminal sends reaches the child by itself.
void pass_on(int signal, siginfo_t* about, void*) {
  if (started_child > 0 && about->si_code != SI_KERNEL) ::kill(started_child, signal);
}

struct sigaction passing(pid_t child) {
  started_child = child;
  struct sigaction action {};
  action.sa_sigaction = pass_on;
  action.sa_flags = SA_SIGINFO;
  return action;
}

/// While one lives, signals that ask to end go to the child and leave this process alone.
class PassedSignals {
 public:
  explicit PassedSignals(pid_t child) : handled_(passing(child), StayIgnored::hang_up) {}
  ~PassedSignals() { started_child = 0; }
  PassedSignals(const PassedSignals&) = delete;
  PassedSignals& operator=(const PassedSignals&) = delete;

 private:
  HandledSignals handled_;
};

}  // namespace

PythonPart study_part() {
  return {"legwright.study",
          {"distributed", "pyarrow"},
          "study",
          "what is done is kept: the same command goes on"};
}
PythonPart drake_part() {
  return {"legwright.drake", {"pydrake", "mujoco"}, "drake", "nothing was written: try it again"};
}
PythonPart parts_part() {
  return {"legwright.parts",
          {"manifold3d", "trimesh", "mujoco"},
          "parts",
          "nothing was written: try it again"};
}

PythonFound look_for_python(const PythonPart& part) {
  std::string tried;
  for (const std::string& python : candidates()) {
    const std::string lack = lack_of(python, part);
    if (lack.empty()) return {python, ""};
    tried += fmt::format("{}{} {}", tried.empty() ? "" : "; ", python, lack);
  }
  return {"", tried};
}

std::string python_cure(const PythonPart& part) {
  return fmt::format(
      "`pip install \".[{}]\"` in a clone, or \"legwright[{}]\" beside an installed wheel; "
      "LEGWRIGHT_PYTHON names a Python other than that of the wheel or python3",
      part.extra, part.extra);
}

int run_python_module(const PythonPart& part, const std::vector<std::string>& arguments) {
  const std::string python = find_python(part);
  std::vector<std::string> words{python, "-P", "-m", part.module};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t here = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    end_with_parent(SIGTERM, here);
    ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  const PassedSignals passed(child);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  const int number = WTERMSIG(status);
  throw IoError(fmt::format("{} -m {} was ended by signal {} ({}); {}", python, part.module, number,
                            strsignal(number), part.when_ended));
}

}  // namespace legwright
