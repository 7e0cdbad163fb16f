// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs/validate_by_python.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "tools/files/exit_code.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/install.hpp"
#include "tools/verbs/viewer_programs.hpp"

namespace legwright {
namespace {

// Prints the version of the package, then that of the engine; nothing where one is missing. Looks
// for the engine without loading it, which takes a second.
constexpr const char* kProbe =
    "import importlib.util as u, legwright\n"
    "print(legwright.__version__, end='')\n"
    "if u.find_spec('pydrake'): print('', 'drake', end='')\n";

std::vector<std::string> candidates() {
  if (const char* own = std::getenv("LEGWRIGHT_PYTHON"); own && *own) return {own};
  return {"python3", "python"};
}

/// The interpreter to run. Throws IoError with what is wrong of each that was tried.
std::string find_python(const std::string& engine) {
  std::string tried;
  for (const std::string& candidate : candidates()) {
    std::string found;
    // -P: what lies in the working directory is no package.
    if (run_command({candidate, "-P", "-c", kProbe}, &found) != 0)
      found = "";
    else if (found == program_version() + " " + engine)
      return candidate;
    const std::string what = found.empty() ? "has no package legwright"
                             : found == program_version()
                                 ? "has legwright, but not " + engine
                                 : fmt::format("has legwright {}, and this program is {}",
                                               found.substr(0, found.find(' ')), program_version());
    tried += fmt::format("{}{} {}", tried.empty() ? "" : "; ", candidate, what);
  }
  throw IoError(fmt::format(
      "--engine {0} runs in Python, which lacks it: {1}. Install it with `pip install "
      "\".[{0}]\"` in a clone, or \"legwright[{0}]\" from a wheel, and name that Python in "
      "LEGWRIGHT_PYTHON",
      engine, tried));
}

}  // namespace

int validate_by_python(const PythonValidation& asked) {
  const std::string python = find_python(asked.engine);
  std::vector<std::string> words{python,
                                 "-P",
                                 "-m",
                                 "legwright." + asked.engine,
                                 asked.run,
                                 "--cycles",
                                 std::to_string(asked.cycles)};
  if (!asked.limits.empty()) words.insert(words.end(), {"--limits", asked.limits});
  if (asked.json) words.emplace_back("--json");
  const int status = run_command(words);
  return status >= 0 ? status : kInternal;
}

}  // namespace legwright
