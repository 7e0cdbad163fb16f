// SPDX-License-Identifier: Apache-2.0
// The program killed at its n-th call to the file system, or told there that the disk is broken or
// full: what it writes is as before or new and whole, errors are told, and the same command then
// works and leaves nothing but its results. For every n with LEGWRIGHT_ALL_FAULTS=1 (some minutes),
// else for some of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/tools/verbs/program.hpp"
#include "tools/files/checksum.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTask =
    "robot = \"robot.xml\"\n[gait]\nname = \"trot\"\nperiod = 0.4\nknots = 10\n"
    "[travel]\n";

constexpr int kTried = 8;  // of the calls, for each way to fail

using Tree = std::map<std::string, std::string>;  // SHA-256 by path

/// Times stand in these files of optimize, so that no two are the same.
bool tells_times(const std::string& path) {
  return path.ends_with("run.json") || path.ends_with("events.jsonl");
}
bool is_lock(const std::string& path) { return path.ends_with("/.lock"); }

Tree tree_of(const fs::path& folder, const std::string& below, bool with_times) {
  Tree out;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = fs::relative(entry.path(), folder).string();
    if (!entry.is_regular_file() || !path.starts_with(below) || is_lock(path)) continue;
    out[path] = tells_times(path) && !with_times ? "" : sha256_hex(read_file(entry.path()));
  }
  return out;
}

/// Names that no finished command leaves, besides what a killed one left of a single file in a
/// folder of the user's.
std::set<std::string> leftovers_in(const fs::path& folder) {
  std::set<std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
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
  bool (*is_unfinished)(const fs::path& folder) = [](const fs::path&) { return false; };
};

void PrintTo(const Case& each, std::ostream* out) { *out << each.name; }

bool is_run_unfinished(const fs::path& folder) {
  const fs::path record = folder / "run/run.json";
  return !fs::exists(record) || Json::parse(read_file(record))["status"] == "running" ||
         Json::parse(read_file(record))["status"] == "failed";
}
bool is_between_results(const fs::path& folder) {
  return fs::exists(folder / "run/.result-picking");
}

class FileFaults : public testing::TestWithParam<Case> {
 protected:
  FileFaults() {
    fs::create_directory(start_);
    fs::copy_file(test::kExamples / "puppy/robot.xml", start_ / "robot.xml");
    fs::copy_file(test::kExamples.parent_path() / "tests/robots/servo_dog/robot.xml",
                  start_ / "dog.xml");
    write_file(start_ / "task.toml", std::string(kTask) + "velocity = [0.05, 0.0]\n");
    write_file(start_ / "other.toml", std::string(kTask) + "velocity = [0.07, 0.0]\n");
    write_file(start_ / "mine.txt", "nobody touches this\n");
    for (const auto& words : GetParam().before)
      EXPECT_EQ(test::call_in(start_, words).code, 0) << words.front();
    for (const char* file : {"out", "err"}) fs::remove(start_ / file);
    old_ = tree(start_);
  }
  Tree tree(const fs::path& folder) const {
    return tree_of(folder, GetParam().writes, GetParam().with_times);
  }
  fs::path copy_of_start(const std::string& name) const {
    const fs::path folder = folder_.path() / name;
    fs::remove_all(folder);
    fs::copy(start_, folder, fs::copy_options::recursive);
    return folder;
  }
  /// @return how the command ends whose call number `at` fails
  test::Outcome call_with_fault(const fs::path& folder, long at, const std::string& how) const {
    const fs::path log = folder_.path() / "log";
    fs::create_directories(log);
    const test::Variable shim("LD_PRELOAD", LEGWRIGHT_FAULT_SHIM),
        root("FAULT_ROOT", fs::canonical(folder).string()), which("FAULT_AT", std::to_string(at)),
        error("FAULT_HOW", how), count("FAULT_COUNT", (folder_.path() / "count").string());
    return test::wait_for(test::start(GetParam().command, folder, log), log);
  }
  long count_calls(const fs::path& folder) const {
    EXPECT_EQ(call_with_fault(folder, 0, "kill").code, 0);
    return std::stol(read_file(folder_.path() / "count"));
  }
  void expect_works_again(const fs::path& folder, const Tree& fresh) const {
    if (tree(folder) == fresh && GetParam().name == "export") return;  // refuses what is there
    const test::Outcome again = call_with_fault(folder, 0, "kill");
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(tree(folder), fresh);
    EXPECT_EQ(leftovers_in(folder), std::set<std::string>{});
    EXPECT_EQ(read_file(folder / "mine.txt"), "nobody touches this\n");
  }

  test::TemporaryFolder folder_;
  fs::path start_ = folder_.path() / "start";
  Tree old_;
};

TEST_P(FileFaults, LeaveTheOldOrTheNew) {
  const fs::path undisturbed = copy_of_start("undisturbed");
  const long calls = count_calls(undisturbed);
  const Tree fresh = tree(undisturbed);
  ASSERT_GT(calls, 2);
  ASSERT_NE(fresh, old_) << "else nothing is tested";
  const long step = std::getenv("LEGWRIGHT_ALL_FAULTS") ? 1 : std::max(1L, calls / kTried);
  for (const char* how : {"kill", "EIO", "ENOSPC"})
    for (long at = 1 + (how[0] + how[1]) % step; at <= calls; at += step) {
      SCOPED_TRACE(std::string(how) + " at call " + std::to_string(at) + " of " +
                   std::to_string(calls));
      const fs::path folder = copy_of_start("disturbed");
      const test::Outcome outcome = call_with_fault(folder, at, how);
      Tree now = tree(folder);
      std::erase_if(now, [](const auto& file) {  // and of a search that may go on
        return file.first.find("/.") != file.first.npos ||
               file.first.starts_with("run/checkpoint/");
      });
      if (std::string(how) == "kill") {
        EXPECT_EQ(outcome.code, -SIGKILL);
        EXPECT_TRUE(now == old_ || now == fresh || GetParam().is_unfinished(folder));
      } else if (outcome.code == 0) {  // it could do without
        EXPECT_EQ(now, fresh);
      } else {
        // MuJoCo does not tell a file that cannot be read from an empty one.
        const bool unread = std::string(how) == "EIO" && outcome.code != 3 &&
                            (outcome.code == 2 || test::contains(outcome.err, "mpty file"));
        EXPECT_TRUE(outcome.code == 3 || unread) << outcome.code << outcome.err;
        EXPECT_NE(outcome.err, "");
        EXPECT_TRUE(now == old_ || now == fresh || GetParam().is_unfinished(folder));
      }
      expect_works_again(folder, fresh);
      if (HasFailure()) return;
    }
}

const std::vector<std::string> kOptimize{"optimize",
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

/// Of a task that gives another result.
std::vector<std::string> other(std::vector<std::string> words) {
  words[1] = "other.toml";
  return words;
}

INSTANTIATE_TEST_SUITE_P(
    Verbs, FileFaults,
    testing::Values(Case{"init", {}, {"init", "dog.xml", "--write"}, "dog.xml"},
                    Case{"optimize", {}, kOptimize, "run/", false, is_run_unfinished},
                    Case{"replace", {other(kOptimize)}, kOptimize, "run/", false},
                    Case{"pick",
                         {kOptimize},
                         {"pick", "run", "--iteration", "0"},
                         "run/",
                         true,
                         is_between_results},
                    Case{"export", {kOptimize}, {"export", "run", "-o", "ex"}, "ex/"}),
    [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace legwright
