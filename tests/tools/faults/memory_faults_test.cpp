// SPDX-License-Identifier: Apache-2.0
// The program whose n-th allocation gets no memory, or that one and all later ones, or of these the
// large ones: it does its work all the same, or ends with exit code 4 and says that memory ran out,
// never by a signal, never blaming a file; what it writes is as before or new and whole, and the
// same command then works. For more n with LEGWRIGHT_FAULT_TRIES=1000, for every one with
// LEGWRIGHT_ALL_FAULTS=1 (days), else for the first and some of the others.
#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "tests/support/long_tests.hpp"
#include "tests/tools/faults/fault_case.hpp"
#include "tools/files/exit_code.hpp"

namespace legwright::test {
namespace {

namespace fs = std::filesystem;

constexpr long kFirst = 8;  // tried one by one
// Of the others, for each way to fail.
constexpr long kTried = 4, kTriedInLongTests = 40;

long tries() {
  const char* const asked = std::getenv("LEGWRIGHT_FAULT_TRIES");
  if (asked == nullptr) return test::long_tests() ? kTriedInLongTests : kTried;
  return std::max(1L, std::atol(asked));
}

std::vector<long> numbers(long calls, long offset) {
  const long step = std::getenv("LEGWRIGHT_ALL_FAULTS") ? 1 : std::max(1L, calls / tries());
  std::set<long> out;
  for (long at = 1; at <= std::min(kFirst, calls); ++at) out.insert(at);
  for (long at = 1 + offset % step; at <= calls; at += step) out.insert(at);
  return {out.begin(), out.end()};
}

class MemoryFaults : public FaultFolder {
 protected:
  Outcome call(const fs::path& folder, long at, const std::string& how) const {
    return call_with_fault(LEGWRIGHT_MEMORY_SHIM, folder, at, how);
  }
  /// Whether each file is as before or as it will be.
  bool is_each_whole(const Tree& now, const Tree& fresh) const {
    return std::all_of(now.begin(), now.end(), [&](const auto& file) {
      const auto before = old_.find(file.first), after = fresh.find(file.first);
      return (before != old_.end() && before->second == file.second) ||
             (after != fresh.end() && after->second == file.second);
    });
  }
  void expect_told(const Outcome& outcome) const {
    EXPECT_EQ(outcome.code, kInternal) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "out of memory")) << outcome.err;
  }
  void expect_works_again(const fs::path& folder, const Tree& fresh, int code) const {
    const bool refuses_what_is_there = GetParam().name == "export" || GetParam().name == "init";
    if (tree(folder) == fresh && refuses_what_is_there) return;
    const Outcome again = call(folder, 0, "once");
    EXPECT_EQ(again.code, code) << again.err;
    EXPECT_EQ(tree(folder), fresh);
    EXPECT_EQ(leftovers_in(folder), std::set<std::string>{});
    EXPECT_EQ(read_file(folder / "mine.txt"), "nobody touches this\n");
  }
};

TEST_P(MemoryFaults, AreToldAsSuch) {
  const fs::path undisturbed = copy_of_start("undisturbed");
  const int code = call(undisturbed, 0, "once").code;
  ASSERT_LE(code, kInfeasible);
  const long calls = counted();
  const Tree fresh = tree(undisturbed);
  ASSERT_GT(calls, 1000);
  long tried = 0, done = 0;
  for (const char* how : {"once", "all", "large"}) {
    fs::path folder = copy_of_start("disturbed");
    for (const long at : numbers(calls, 131 * how[0])) {
      SCOPED_TRACE(std::string(how) + " at allocation " + std::to_string(at) + " of " +
                   std::to_string(calls));
      const Outcome outcome = call(folder, at, how);
      ++tried;
      const Tree now = results_of(tree(folder));
      if (outcome.code == code) {  // it could do without
        EXPECT_EQ(now, fresh);
        ++done;
      } else {
        expect_told(outcome);
        EXPECT_TRUE(stands(now, fresh, folder) || is_each_whole(now, fresh));
      }
      for (const auto& entry : fs::directory_iterator(folder))
        EXPECT_FALSE(entry.is_regular_file() && entry.path().filename().string().starts_with('.'))
            << entry.path();
      if (tree(folder) != old_ || leftovers_in(folder).size() > 0) {
        expect_works_again(folder, fresh, code);
        folder = copy_of_start("disturbed");
      }
      if (HasFailure()) return;
    }
    expect_works_again(folder, fresh, code);
  }
  std::cout << GetParam().name << ": " << calls << " allocations, " << tried << " tried, " << done
            << " done, " << tried - done << " told\n";
  test::tell_tries("allocations without memory, " + GetParam().name, tried);
  EXPECT_LT(done, tried) << "else nothing is tested";
}

std::vector<std::string> in_threads(std::vector<std::string> words) {
  *std::find(words.begin(), words.end(), "1") = "3";
  return words;
}

INSTANTIATE_TEST_SUITE_P(
    Verbs, MemoryFaults,
    testing::Values(
        Case{"check", {}, {"check", "task.toml"}, ""},
        Case{"init", {}, {"init", "dog.xml", "--write", "--task", "new.toml"}, ""},
        Case{"optimize", {}, kOptimize, "", false, is_run_unfinished},
        Case{"threads", {}, in_threads(kOptimize), "", false, is_run_unfinished},
        Case{
            "pick", {kOptimize}, {"pick", "run", "--iteration", "0"}, "", true, is_between_results},
        Case{"validate", {kOptimize}, {"validate", "run", "--quick", "--cycles", "4"}, "", false},
        Case{"export", {kOptimize}, {"export", "run", "-o", "ex", "--no-picture"}, ""},
        Case{"report", {kOptimize}, {"report", "run"}, ""}),
    [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace legwright::test
