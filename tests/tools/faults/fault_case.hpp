// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/tools/verbs/program.hpp"
#include "tools/files/checksum.hpp"

/// What tests share that disturb the program at its n-th call of some function.
namespace legwright::test {

using Tree = std::map<std::string, std::string>;  // SHA-256 by path

/// Times stand in these files of optimize, so that no two are the same.
inline bool tells_times(const std::string& path) {
  return path.ends_with("run.json") || path.ends_with("events.jsonl");
}
inline bool is_lock(const std::string& path) { return path.ends_with("/.lock"); }

inline Tree tree_of(const std::filesystem::path& folder, const std::string& below,
                    bool with_times) {
  namespace fs = std::filesystem;
  Tree out;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = fs::relative(entry.path(), folder).string();
    if (!entry.is_regular_file() || !path.starts_with(below) || is_lock(path)) continue;
    out[path] = tells_times(path) && !with_times ? "" : sha256_hex(read_file(entry.path()));
  }
  return out;
}

/// Without what a search that may go on keeps.
inline Tree results_of(Tree tree) {
  std::erase_if(tree, [](const auto& file) {
    return file.first.starts_with('.') || file.first.find("/.") != file.first.npos ||
           file.first.starts_with("run/checkpoint/");
  });
  return tree;
}

/// Names that no finished command leaves, besides what a killed one left of a single file in a
/// folder of the user's.
inline std::set<std::string> leftovers_in(const std::filesystem::path& folder) {
  std::set<std::string> out;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.') && name != ".lock" && entry.path().parent_path() != folder)
      out.insert(name);
    if (name.starts_with('.') && entry.is_directory()) out.insert(name);
  }
  return out;
}

struct Case {
  std::string name;
  std::vector<std::vector<std::string>> before;
  std::vector<std::string> command;
  std::string writes;  // head of the paths of what it writes
  bool with_times = true;
  // Whether it stands in the folder itself that a command did not end there.
  bool (*is_unfinished)(const std::filesystem::path& folder) = [](const std::filesystem::path&) {
    return false;
  };
  int ends = 0;                       // exit code of the command where nothing disturbs it
  bool is_one_change = true;          // else each of its files is as before or new by itself
  std::vector<std::string> killed{};  // a command before, killed at two thirds of its calls
  // Whether what is written tells itself what it does without.
  bool (*is_told)(const std::filesystem::path& folder) = [](const std::filesystem::path&) {
    return false;
  };
};

inline void PrintTo(const Case& each, std::ostream* out) { *out << each.name; }

inline bool is_run_unfinished(const std::filesystem::path& folder) {
  const std::filesystem::path record = folder / "run/run.json";
  return !std::filesystem::exists(record) ||
         Json::parse(read_file(record))["status"] == "running" ||
         Json::parse(read_file(record))["status"] == "failed";
}
inline bool is_between_results(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "run/.result-picking");
}

/// A folder with robots, tasks and what the commands before made of them, copied for each try.
class FaultFolder : public testing::TestWithParam<Case> {
 protected:
  /// What is judged falls: its exit code is 1.
  FaultFolder() {
    namespace fs = std::filesystem;
    constexpr const char* kTask =
        "robot = \"robot.xml\"\n[gait]\nname = \"trot\"\nperiod = 0.4\nknots = 10\n"
        "[travel]\n";
    fs::create_directory(start_);
    fs::copy_file(kExamples / "puppy/robot.xml", start_ / "robot.xml");
    fs::copy_file(kExamples.parent_path() / "tests/robots/servo_dog/robot.xml", start_ / "dog.xml");
    write_file(start_ / "task.toml", std::string(kTask) + "velocity = [0.05, 0.0]\n");
    write_file(start_ / "other.toml", std::string(kTask) + "velocity = [0.07, 0.0]\n");
    write_file(start_ / "mine.txt", "nobody touches this\n");
    for (const auto& words : GetParam().before)
      EXPECT_EQ(call_in(start_, words).code, words.front() == "validate" ? 1 : 0) << words.front();
    for (const char* file : {"out", "err"}) fs::remove(start_ / file);
    old_ = tree(start_);
  }
  Tree tree(const std::filesystem::path& folder) const {
    return tree_of(folder, GetParam().writes, GetParam().with_times);
  }
  std::filesystem::path copy_of_start(const std::string& name) const {
    const std::filesystem::path folder = folder_.path() / name;
    std::filesystem::remove_all(folder);
    std::filesystem::copy(start_, folder, std::filesystem::copy_options::recursive);
    return folder;
  }
  /// @param shim the library to be loaded before the program
  /// @return how the command ends whose call number `at` fails
  Outcome call_with_fault(const char* shim, const std::filesystem::path& folder, long at,
                          const std::string& how) const {
    return command_with_fault(GetParam().command, shim, folder, at, how);
  }
  Outcome command_with_fault(const std::vector<std::string>& command, const char* shim,
                             const std::filesystem::path& folder, long at,
                             const std::string& how) const {
    const std::filesystem::path log = folder_.path() / "log";
    std::filesystem::create_directories(log);
    const Variable loaded("LD_PRELOAD", shim),
        root("FAULT_ROOT", std::filesystem::canonical(folder).string()),
        which("FAULT_AT", std::to_string(at)), error("FAULT_HOW", how),
        count("FAULT_COUNT", (folder_.path() / "count").string());
    return wait_for(start(command, folder, log), log);
  }
  long counted() const { return std::stol(read_file(folder_.path() / "count")); }
  bool stands(const Tree& now, const Tree& fresh, const std::filesystem::path& folder) const {
    const auto is_in = [](const Tree& there, const auto& file) {
      const auto found = there.find(file.first);
      return found != there.end() && found->second == file.second;
    };
    const bool each_stands = std::all_of(now.begin(), now.end(), [&](const auto& file) {
      return is_in(old_, file) || is_in(fresh, file);
    });
    return now == old_ || now == fresh || (!GetParam().is_one_change && each_stands) ||
           GetParam().is_unfinished(folder);
  }

  TemporaryFolder folder_;
  std::filesystem::path start_ = folder_.path() / "start";
  Tree old_;
};

inline const std::vector<std::string> kOptimize{"optimize",
                                                "task.toml",
                                                "-o",
                                                "run",
                                                "--motion-only",
                                                "--plan-only",
                                                "--no-pictures",
                                                "--no-reasons",
                                                "--no-certificate",
                                                "--threads",
                                                "1",
                                                "--force"};

}  // namespace legwright::test
