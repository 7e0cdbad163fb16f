// SPDX-License-Identifier: Apache-2.0
// The program killed at its n-th call to the file system, or told there that the disk is broken or
// full: what it writes is as before or new and whole, errors are told, and the same command then
// works and leaves nothing but its results. For every n with LEGWRIGHT_LONG_TESTS=1 (some minutes,
// but for export with its picture each fifth), else for some of them.
#include <algorithm>
#include <cstdlib>

#include "tests/support/long_tests.hpp"
#include "tests/tools/faults/fault_case.hpp"

namespace legwright::test {
namespace {

namespace fs = std::filesystem;

/// From one call that is tried to the next, for each way to fail; farther where a picture is drawn,
/// which takes seconds.
long step_of(const std::string& name, long calls) {
  const bool draws = name == "export" || name == "render";
  if (test::long_tests()) return draws ? 5 : 1;
  return std::max(1L, calls / (draws ? 2 : 5));
}

class FileFaults : public FaultFolder {
 protected:
  FileFaults() {
    const std::vector<std::string>& killed = GetParam().killed;
    if (killed.empty()) return;
    const fs::path whole = copy_of_start("whole");
    EXPECT_EQ(command_with_fault(killed, LEGWRIGHT_FAULT_SHIM, whole, 0, "kill").code, 0);
    const long at = 2 * counted() / 3;
    EXPECT_EQ(command_with_fault(killed, LEGWRIGHT_FAULT_SHIM, start_, at, "kill").code, -SIGKILL);
    old_ = tree(start_);
  }
  Outcome call(const fs::path& folder, long at, const std::string& how) const {
    return call_with_fault(LEGWRIGHT_FAULT_SHIM, folder, at, how);
  }
  void expect_works_again(const fs::path& folder, const Tree& fresh) const {
    const std::string& name = GetParam().name;
    const bool refuses_what_is_there = name.starts_with("export") || name == "resume";
    if (tree(folder) == fresh && refuses_what_is_there) return;
    const Outcome again = call(folder, 0, "kill");
    EXPECT_EQ(again.code, GetParam().ends) << again.err;
    EXPECT_EQ(tree(folder), fresh);
    EXPECT_EQ(leftovers_in(folder), std::set<std::string>{});
    EXPECT_EQ(read_file(folder / "mine.txt"), "nobody touches this\n");
  }
};

TEST_P(FileFaults, LeaveTheOldOrTheNew) {
  const fs::path undisturbed = copy_of_start("undisturbed");
  const Outcome first = call(undisturbed, 0, "kill");
  EXPECT_EQ(first.code, GetParam().ends) << first.err;
  const long calls = counted();
  const Tree fresh = tree(undisturbed);
  ASSERT_GT(calls, 2);
  ASSERT_NE(fresh, old_) << "else nothing is tested";
  const long step = step_of(GetParam().name, calls);
  long done = 0;
  for (const char* how : {"kill", "EIO", "ENOSPC"})
    for (long at = 1 + (how[0] + how[1]) % step; at <= calls; at += step) {
      SCOPED_TRACE(std::string(how) + " at call " + std::to_string(at) + " of " +
                   std::to_string(calls));
      const fs::path folder = copy_of_start("disturbed");
      const Outcome outcome = call(folder, at, how);
      const Tree now = results_of(tree(folder));
      if (std::string(how) == "kill") {
        EXPECT_EQ(outcome.code, -SIGKILL);
        EXPECT_TRUE(stands(now, fresh, folder));
      } else if (outcome.code == GetParam().ends) {  // it could do without
        if (!GetParam().is_told(folder)) {
          EXPECT_EQ(now, fresh);
        }
      } else {
        // MuJoCo does not tell a file that cannot be read from an empty one.
        const bool unread = std::string(how) == "EIO" && outcome.code != 3 &&
                            (outcome.code == 2 || contains(outcome.err, "mpty file"));
        EXPECT_TRUE(outcome.code == 3 || unread) << outcome.code << outcome.err;
        EXPECT_NE(outcome.err, "");
        EXPECT_TRUE(stands(now, fresh, folder));
      }
      expect_works_again(folder, fresh);
      ++done;
      if (HasFailure()) return;
    }
  test::tell_tries("deaths and disk faults at a file call, " + GetParam().name, done);
}

/// Of a task that gives another result.
std::vector<std::string> other(std::vector<std::string> words) {
  words[1] = "other.toml";
  return words;
}

std::vector<std::string> judged_for(const std::string& cycles) {
  return {"validate", "run", "--quick", "--cycles", cycles};
}
/// A report says what could not be read.
bool says_what_failed(const fs::path& folder) {
  const std::string page = read_file(folder / "run/report.html");
  return contains(page, "Input/output error") || contains(page, "mpty file");
}
bool never_unfinished(const fs::path& /*folder*/) { return false; }

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
                    Case{"resume",
                         {},
                         {"optimize", "--resume", "run"},
                         "run/",
                         false,
                         is_run_unfinished,
                         0,
                         true,
                         kOptimize},
                    Case{"validate",
                         {kOptimize},
                         {"validate", "run", "--quick", "--cycles", "5"},
                         "run/result/",
                         true,
                         never_unfinished,
                         1},
                    Case{"validate_again",
                         {kOptimize, judged_for("4")},
                         judged_for("5"),
                         "run/result/",
                         true,
                         never_unfinished,
                         1},
                    Case{"render",
                         {kOptimize},
                         {"render", "run", "--still"},
                         "run/result/",
                         true,
                         never_unfinished,
                         0,
                         false},
                    Case{"report",
                         {kOptimize, {"report", "run"}, judged_for("4")},
                         {"report", "run"},
                         "run/re",
                         true,
                         never_unfinished,
                         0,
                         false,
                         {},
                         says_what_failed},
                    Case{"export", {kOptimize}, {"export", "run", "-o", "ex"}, "ex/"},
                    Case{"export_without_picture",
                         {kOptimize},
                         {"export", "run", "-o", "ex", "--no-picture"},
                         "ex/"}),
    [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace legwright::test
