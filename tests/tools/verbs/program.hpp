// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/support/paths.hpp"
#include "tests/support/variable.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/json_file.hpp"

/// The built program, called as people call it.
namespace legwright::test {

inline const std::filesystem::path kExamples =
    std::filesystem::path(test::source_dir()) / "examples";

/// The limits that a design's part of verdict.json does not keep.
inline std::set<std::string> failing_limits(const Json& verdict) {
  std::set<std::string> out;
  for (const Json& row : verdict["limits"])
    if (!row["pass"].get<bool>()) out.insert(row["name"].get<std::string>());
  return out;
}

/// Which of them a gait fails that only does not keep its heading.
inline const std::set<std::string> kDriftLimits{"heading_drift_per_cycle", "path_deviation"};

/// Makes a run one of an older program, which knows no sums of its scenes: a test edits one.
inline void forget_sums_of_scenes(const std::filesystem::path& run) {
  Json record = read_json(run / "run.json");
  record.erase("scenes");
  std::filesystem::remove(run / "run.json");  // it may be a link to one that others read
  write_json(run / "run.json", record);
}

struct Outcome {
  int code = -1;
  std::string out, err;
};

/// Starts the program in `folder`, with its output in the files out and err of `outputs`.
inline pid_t start(const std::vector<std::string>& words, const std::filesystem::path& folder,
                   const std::filesystem::path& outputs) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  const auto redirect = [&](const char* name, int to) {
    ::dup2(::open((outputs / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), to);
  };
  redirect("out", STDOUT_FILENO);
  redirect("err", STDERR_FILENO);
  std::string program = test::program();
  std::vector<char*> argv{program.data()};
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  if (::chdir(folder.c_str()) == 0) ::execv(argv[0], argv.data());
  ::_exit(126);
}

inline pid_t start(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  return start(words, folder, folder);
}

inline Outcome wait_for(pid_t child, const std::filesystem::path& folder) {
  int status = 0;
  ::waitpid(child, &status, 0);
  Outcome outcome;
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  outcome.out = read_file(folder / "out");
  outcome.err = read_file(folder / "err");
  return outcome;
}

inline Outcome call_in(const std::filesystem::path& folder, const std::vector<std::string>& words) {
  return wait_for(start(words, folder), folder);
}

inline Outcome call(const std::vector<std::string>& words) {
  return call_in(TemporaryFolder().path(), words);
}

/// A part of a fixture that calls the program in a folder of its own.
class CallsInFolder {
 protected:
  Outcome call(const std::vector<std::string>& words) const {
    return call_in(folder_.path(), words);
  }
  TemporaryFolder folder_;
};

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace legwright::test
