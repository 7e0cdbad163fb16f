// SPDX-License-Identifier: Apache-2.0
// What a shell does to the program: streams that are closed or full, readers that go away, pipes
// and devices in the place of files, texts that nest without end.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "tests/support/paths.hpp"
#include "tests/tools/verbs/program.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

class Process : public testing::Test, protected test::CallsInFolder {
 protected:
  /// The exit code of a line of shell in the folder; $LEGWRIGHT is the program.
  int shell(const std::string& line) const {
    const std::string command = "cd '" + folder_.path().string() + "' && LEGWRIGHT='" +
                                test::program() + "' && TASK='" +
                                (test::kExamples / "puppy/sideways.toml").string() +
                                "' && FAST='--motion-only --plan-only --no-pictures' && " + line;
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string text(const std::string& name) const { return read_file(folder_.path() / name); }
  void expect_whole_run() const {
    EXPECT_NE(Json::parse(text("run/run.json"))["status"], "running");
    std::istringstream lines(text("run/events.jsonl"));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count)
      EXPECT_TRUE(Json::accept(line)) << line;
    EXPECT_GE(count, 3);
  }
};

TEST_F(Process, ClosedStreamsGetNothingIntoTheFilesOfTheRun) {
  EXPECT_LE(shell("\"$LEGWRIGHT\" optimize \"$TASK\" $FAST -o run <&- >&- 2>&-"), 1);
  expect_whole_run();
}

TEST_F(Process, ProgressThatNobodyReadsDoesNotEndTheRun) {
  EXPECT_EQ(shell("{ \"$LEGWRIGHT\" optimize \"$TASK\" $FAST -o run > out; echo $? > code; } 2>&1 "
                  "| true"),
            0);
  EXPECT_LE(text("code"), "1\n");
  EXPECT_NE(text("out"), "");
  expect_whole_run();
}

TEST_F(Process, OutputThatDoesNotGetThereIsAnError) {
  EXPECT_EQ(shell("\"$LEGWRIGHT\" gaits > out 2> err"), 0);  // else the rest proves nothing
  EXPECT_EQ(shell("\"$LEGWRIGHT\" gaits > /dev/full 2> err"), 3);
  EXPECT_TRUE(test::contains(text("err"), "No space left")) << text("err");
  EXPECT_EQ(shell("\"$LEGWRIGHT\" --help > /dev/full 2> err"), 3);
  EXPECT_EQ(shell("{ \"$LEGWRIGHT\" check --keys; echo $? > code; } 2> err | true"), 0);
  EXPECT_EQ(text("code"), "3\n");
  EXPECT_EQ(text("err"), "") << "a reader that goes away has seen enough";
}

TEST_F(Process, JunitGoesIntoStdoutBesideTheVerdict) {
  ASSERT_LE(shell("\"$LEGWRIGHT\" optimize \"$TASK\" $FAST -o run > out 2> err"), 1);
  for (const char* to : {"> both", "| cat > both"}) {
    SCOPED_TRACE(to);
    EXPECT_LE(shell(std::string("\"$LEGWRIGHT\" validate run --quick --junit /dev/stdout ") + to),
              1);
    EXPECT_TRUE(test::contains(text("both"), "<testsuite")) << text("both");
    EXPECT_TRUE(test::contains(text("both"), "initial design:")) << text("both");
  }
}

TEST_F(Process, PipesDevicesAndEndlessNestingAreRefusedAtOnce) {
  ASSERT_EQ(::mkfifo((folder_.path() / "fifo").c_str(), 0600), 0);
  for (const char* file : {"fifo", "/dev/zero"}) {
    const test::Outcome outcome = call({"check", file});
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_TRUE(test::contains(outcome.err, "expected a regular file")) << outcome.err;
  }
  std::string dots = "robot = \"a.b.c\" # d.e\n\n[gait]\na";
  for (int k = 0; k < 40000; ++k) dots += ".b";
  write_file(folder_.path() / "deep.toml", dots + " = 1\n");
  const test::Outcome deep = call({"check", "deep.toml"});
  EXPECT_EQ(deep.code, 2) << deep.err;
  EXPECT_TRUE(test::contains(deep.err, "deep.toml:4: ")) << deep.err;
  EXPECT_TRUE(test::contains(deep.err, "more than 32 parts")) << deep.err;
  fs::create_directories(folder_.path() / "run");
  write_file(folder_.path() / "run/run.json", std::string(200'000, '['));
  const test::Outcome nested = call({"report", "run"});
  EXPECT_EQ(nested.code, 3) << nested.err;
  EXPECT_TRUE(test::contains(nested.err, "is damaged")) << nested.err;
}

TEST_F(Process, APipeInThePlaceOfAPictureIsRefusedByTheReport) {
  ASSERT_LE(shell("\"$LEGWRIGHT\" optimize \"$TASK\" $FAST -o run > out 2> err"), 1);
  ASSERT_EQ(::mkfifo((folder_.path() / "run/result/gait.webp").c_str(), 0600), 0);
  const test::Outcome outcome = call({"report", "run"});
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_TRUE(test::contains(outcome.err, "expected a regular file")) << outcome.err;
}

// The second writer of a run is told who the first one is; a killed one is in nobody's way.
TEST_F(Process, ARunHasOneWriterAtATime) {
  const std::string task = (test::kExamples / "puppy/sideways.toml").string();
  const fs::path run = folder_.path() / "run";
  const test::TemporaryFolder elsewhere;
  const pid_t first =
      test::start({"optimize", task, "--no-pictures", "-o", run.string()}, elsewhere.path());
  for (int n = 0; n < 1000 && !fs::exists(run / "iterations/0000"); ++n) ::usleep(10'000);
  ASSERT_TRUE(fs::exists(run / "iterations/0000"));
  ::kill(first, SIGSTOP);  // it stays where it is
  const std::string who = "in use by process " + std::to_string(first) + " on ";
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"optimize", task, "-o", "run"},
                                             {"optimize", task, "--force", "-o", "run"},
                                             {"validate", "run"},
                                             {"render", "run"},
                                             {"report", "run"},
                                             {"pick", "run", "--iteration", "0"},
                                             {"export", "run", "-o", "run/mine"}}) {
    const test::Outcome outcome = call(words);
    EXPECT_EQ(outcome.code, 3) << words[0] << outcome.err;
    EXPECT_TRUE(test::contains(outcome.err, who)) << words[0] << outcome.err;
  }
  EXPECT_EQ(call({"curves", "run"}).code, 2) << "a reader is not kept away";
  ::kill(first, SIGKILL);
  ::waitpid(first, nullptr, 0);
  EXPECT_LE(shell("\"$LEGWRIGHT\" optimize \"$TASK\" $FAST --force -o run > out 2> err"), 1)
      << text("err");
  expect_whole_run();
}

TEST_F(Process, AKilledRunLeavesTheOneThatItWasToReplace) {
  ASSERT_LE(shell("\"$LEGWRIGHT\" optimize \"$TASK\" $FAST -o run > out 2> err"), 1);
  ASSERT_LE(shell("\"$LEGWRIGHT\" validate run --quick > out 2> err && \"$LEGWRIGHT\" report run "
                  "> out 2> err"),
            1);
  const std::string before = text("run/run.json"), verdict = text("run/result/verdict.json");
  const std::string task = (test::kExamples / "puppy/sideways.toml").string();
  const fs::path run = folder_.path() / "run";
  const auto beside = [&] {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      if (entry.path().filename().string().starts_with(".run.new-")) found.push_back(entry.path());
    return found;
  };
  const test::TemporaryFolder elsewhere;
  const pid_t killed = test::start(
      {"optimize", task, "--no-pictures", "--force", "-o", run.string()}, elsewhere.path());
  for (int n = 0; n < 1000 && (beside().empty() || !fs::exists(beside()[0] / "iterations/0000"));
       ++n)
    ::usleep(10'000);
  ASSERT_EQ(beside().size(), 1U);
  ::kill(killed, SIGKILL);
  ::waitpid(killed, nullptr, 0);
  EXPECT_EQ(text("run/run.json"), before);
  EXPECT_EQ(text("run/result/verdict.json"), verdict);
  EXPECT_EQ(call({"report", "run"}).code, 0);
  EXPECT_EQ(beside().size(), 1U);

  write_file(run / "notes.txt", "mine");
  const test::Outcome kept = call({"optimize", task, "--force", "-o", "run"});
  EXPECT_EQ(kept.code, 3);
  EXPECT_TRUE(test::contains(kept.err, "notes.txt")) << kept.err;
  fs::remove(run / "notes.txt");
  EXPECT_LE(shell("\"$LEGWRIGHT\" optimize \"$TASK\" $FAST --force -o run > out 2> err"), 1)
      << text("err");
  expect_whole_run();
  EXPECT_FALSE(fs::exists(run / "result/verdict.json")) << "of the old run";
  EXPECT_FALSE(fs::exists(run / "report.html"));
  EXPECT_TRUE(beside().empty());
}

TEST_F(Process, AFolderThatIsRemovedInMidRunEndsIt) {
  const std::string task = (test::kExamples / "puppy/sideways.toml").string();
  const fs::path run = folder_.path() / "run";
  const test::TemporaryFolder elsewhere;
  const pid_t child =
      test::start({"optimize", task, "--no-pictures", "-o", run.string()}, elsewhere.path());
  for (int n = 0; n < 1000 && !fs::exists(run / "iterations/0000"); ++n) ::usleep(10'000);
  const fs::path away = folder_.path() / "away";
  fs::rename(run, away);  // at once, where removing takes a while
  const test::Outcome outcome = test::wait_for(child, elsewhere.path());
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_TRUE(test::contains(outcome.err, "was removed or replaced while it was written"))
      << outcome.err;
  EXPECT_FALSE(fs::exists(run)) << "it came back";
}

}  // namespace
}  // namespace legwright
