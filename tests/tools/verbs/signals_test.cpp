// SPDX-License-Identifier: Apache-2.0
// Signals that ask the program to end: how soon it does, and what it leaves.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include "tests/support/long_tests.hpp"
#include "tests/tools/verbs/program.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;

class Signals : public testing::Test, protected test::CallsInFolder {
 protected:
  /// The tests themselves may run in the background.
  void SetUp() override {
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    for (std::size_t k = 0; k < kAsking.size(); ++k) sigaction(kAsking[k], &usual, &before_[k]);
  }
  void TearDown() override {
    for (std::size_t k = 0; k < kAsking.size(); ++k) sigaction(kAsking[k], &before_[k], nullptr);
  }

  pid_t begin(const Words& words) const {
    return test::start(words, folder_.path(), beside_.path());
  }
  /// As who starts it ignores a signal.
  pid_t begin_ignoring(int signal, const Words& words) const {
    struct sigaction ignore {};
    struct sigaction before {};
    ignore.sa_handler = SIG_IGN;
    sigaction(signal, &ignore, &before);
    const pid_t child = begin(words);
    sigaction(signal, &before, nullptr);
    return child;
  }
  test::Outcome end_of(pid_t child) const { return test::wait_for(child, beside_.path()); }
  fs::path at(const std::string& name) const { return folder_.path() / name; }

  /// A motion of the puppy, three designs on the way.
  void make_run() const {
    const std::string task = (test::kExamples / "puppy/sideways.toml").string();
    const test::Outcome made =
        end_of(begin({"optimize", task, "-o", "run", "--plan-only", "--max-iterations", "2",
                      "--no-reasons", "--no-certificate", "--no-pictures"}));
    ASSERT_LE(made.code, 1) << made.err;
    ASSERT_TRUE(fs::exists(at("run/iterations/0001/scene.xml"))) << "nothing to pick";
  }

  /// Whatever stands there that people do not see, but for what a run has always.
  std::string hidden() const {
    std::string out;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
      if (entry.path().filename().string().starts_with('.'))
        out += entry.path().lexically_relative(folder_.path()).string() + " ";
    return out;
  }

  /// Waits until it is there, at most ten seconds.
  static bool appears(const fs::path& path) {
    for (int n = 0; n < 1000 && !fs::exists(path); ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return fs::exists(path);
  }

  /// Calls the verb again and again, each time with a signal a little later, until one comes too
  /// late. @return how often the signal ended it
  int stop_all_along(const Words& words, int signal, const std::function<void()>& look) {
    const auto begun = Clock::now();
    EXPECT_LE(end_of(begin(words)).code, 1);
    look();
    const int moments = test::long_tests() ? 40 : 8;
    const auto step = (Clock::now() - begun) / moments;
    int stopped = 0;
    for (int n = 0; n < moments; ++n) {
      const pid_t child = begin(words);
      std::this_thread::sleep_for(n * step);
      ::kill(child, signal);
      const int code = end_of(child).code;
      EXPECT_TRUE(code == 0 || code == 1 || code == -signal) << code;
      stopped += code == -signal ? 1 : 0;
      EXPECT_EQ(hidden(), "") << words.front() << ", moment " << n;
      look();
    }
    test::tell_tries("signals at some moment of " + words.front(), moments);
    return stopped;
  }

  static constexpr std::array<int, 3> kAsking{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kAsking.size()> before_;
  test::TemporaryFolder beside_;  // what the program prints
};

TEST_F(Signals, AHangUpThatNohupIgnoresDoesNotStopARun) {
  const std::string task = (test::kExamples / "puppy/sideways.toml").string();
  const pid_t child = begin_ignoring(
      SIGHUP, {"optimize", task, "-o", "run", "--plan-only", "--no-reasons", "--no-pictures"});
  ASSERT_TRUE(appears(at("run/iterations/0000")));
  ::kill(child, SIGHUP);
  EXPECT_LE(end_of(child).code, 1);
  EXPECT_NE(read_json(at("run/run.json"))["status"], "stopped");
}

/// As of a script's job in the background.
TEST_F(Signals, AVerdictGoesOnWhereAnInterruptIsIgnored) {
  make_run();
  const pid_t child = begin_ignoring(SIGINT, {"validate", "run", "--quick"});
  ASSERT_TRUE(appears(at("run/.lock")));
  ::kill(child, SIGINT);
  EXPECT_GE(end_of(child).code, 0) << "it died of the signal";
  EXPECT_TRUE(fs::exists(at("run/result/verdict.json")));
}

TEST_F(Signals, AHangUpStopsARunThatNobodyShields) {
  const std::string task = (test::kExamples / "puppy/sideways.toml").string();
  const pid_t child = begin({"optimize", task, "-o", "run", "--no-pictures"});
  ASSERT_TRUE(appears(at("run/iterations/0000")));
  ::kill(child, SIGHUP);
  EXPECT_EQ(end_of(child).code, 75);
}

TEST_F(Signals, AStoppedExportIsWholeOrNotThere) {
  make_run();
  const int stopped = stop_all_along({"export", "run", "-o", "out"}, SIGTERM, [&] {
    EXPECT_EQ(fs::exists(at("out")), fs::exists(at("out/README.md")));
    fs::remove_all(at("out"));
  });
  EXPECT_GT(stopped, 0);
}

TEST_F(Signals, AStoppedPickLeavesTheOldResultOrTheNew) {
  make_run();
  const std::string given = read_file(at("run/iterations/0000/scene.xml"));
  int n = 0;
  const int stopped = stop_all_along({"pick", "run", "--iteration", "0"}, SIGINT, [&] {
    const Json record = read_json(at("run/run.json"));
    const bool is_given = record.contains("picked") && record["picked"] == "iteration 0";
    EXPECT_EQ(read_file(at("run/result/scene.xml")) == given, is_given) << n;
    ASSERT_EQ(call({"pick", "run", "--iteration", "1"}).code, 0) << n++;
  });
  EXPECT_GT(stopped, 0);
}

TEST_F(Signals, StoppedVerdictsPicturesAndPagesLeaveNothingBehind) {
  make_run();
  for (const Words& words :
       {Words{"validate", "run", "--quick"}, {"render", "run", "--still"}, {"report", "run"}})
    EXPECT_GT(stop_all_along(words, SIGTERM, [] {}), 0) << words.front();
}

// Processor time, on one thread, as the machine may be busy.
TEST_F(Signals, ASearchOfManyKnotsEndsAtOnce) {
  std::string task = read_file(test::kExamples / "hexapod/tripod_0.5.toml");
  const auto put = [&task](const std::string& from, const std::string& to) {
    ASSERT_NE(task.find(from), std::string::npos);
    task.replace(task.find(from), from.size(), to);
  };
  put("\"robot.xml\"", "\"" + (test::kExamples / "hexapod/robot.xml").string() + "\"");
  put("knots = 20", "knots = 384");
  write_file(at("many.toml"), task);
  const auto seconds_of = [](pid_t child) {
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    std::string text{std::istreambuf_iterator<char>(stat), {}};
    std::istringstream fields(text.substr(text.rfind(')') + 2));
    std::string field;
    for (int k = 0; k < 11; ++k) fields >> field;  // up to the fourteenth, the time of users
    double user = 0.0, system = 0.0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  };
  for (const int tenths : {10, 25}) {
    const fs::path events = at("run" + std::to_string(tenths)) / "events.jsonl";
    const pid_t child = begin({"optimize", "many.toml", "-o", "run" + std::to_string(tenths),
                               "--threads", "1", "--no-pictures"});
    double before = 0.0;
    for (int n = 0;
         n < 12000 && (!fs::exists(events) || (before = seconds_of(child)) < 0.1 * tenths); ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_GE(before, 0.1 * tenths);
    ::kill(child, SIGTERM);
    int status = 0;
    struct rusage used {};
    ASSERT_EQ(::wait4(child, &status, 0, &used), child);
    const auto seconds = [](const timeval& time) {
      return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 75) << status;
    // 1 to 1.6 s of a quiet processor; to its end the search takes minutes.
    EXPECT_LT(seconds(used.ru_utime) + seconds(used.ru_stime) - before, 10.0) << tenths;
  }
}

}  // namespace
}  // namespace legwright
