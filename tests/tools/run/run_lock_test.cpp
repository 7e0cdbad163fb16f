// SPDX-License-Identifier: Apache-2.0
#include "tools/run/run_lock.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <memory>

#include "tests/support/long_tests.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/result_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

constexpr int kWon = 0, kRefused = 3, kBroken = 4;

void write_run_json(const fs::path& run) {
  fs::create_directories(run);
  write_json(run / "run.json", {{"schema", "legwright/run"}}, Durability::process);
}

std::string refusal(const fs::path& run) {
  try {
    const RunLock lock(run);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

/// A way for processes to wait for each other: what was written, or that all writers are gone.
class Pipe {
 public:
  Pipe() { EXPECT_EQ(::pipe(ends_.data()), 0); }
  ~Pipe() {
    close_read();
    close_write();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void say() { EXPECT_EQ(::write(ends_[1], "x", 1), 1); }
  /// @return whether somebody said something; no: nobody is left who could
  bool wait() {
    char c = 0;
    return ::read(ends_[0], &c, 1) == 1;
  }
  void close_read() { close_end(0); }
  void close_write() { close_end(1); }

 private:
  void close_end(int end) {
    if (ends_[end] >= 0) ::close(ends_[end]);
    ends_[end] = -1;
  }
  std::array<int, 2> ends_{-1, -1};
};

pid_t forked(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  return child;
}

class RunLockOf : public testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  const fs::path run_ = folder_.path() / "run";
};

TEST_F(RunLockOf, ARunKeepsOthersAwayAndTellsWhoItIs) {
  write_run_json(run_);
  {
    const RunLock lock(run_);
    EXPECT_TRUE(lock.stands());
    const std::string told = refusal(run_);
    const std::string head =
        run_.string() + " is in use by process " + std::to_string(::getpid()) + " on ";
    EXPECT_EQ(told.substr(0, head.size()), head);
    EXPECT_NE(told.find(" UTC: wait for it or choose another folder"), std::string::npos) << told;
    fs::create_directory_symlink(run_, folder_.path() / "link");
    EXPECT_NE(refusal(folder_.path() / "link"), "") << "another way to it";
    EXPECT_THROW(ResultFolder::open_to_write(run_), IoError);
    EXPECT_THROW(ResultFolder::create(run_, true), IoError);
    EXPECT_NO_THROW(ResultFolder::open(run_)) << "readers need none";
  }
  EXPECT_FALSE(fs::exists(run_ / RunLock::kFile));
  EXPECT_EQ(refusal(run_), "");
}

TEST_F(RunLockOf, AKilledProcessIsInNobodysWay) {
  write_run_json(run_);
  Pipe locked;
  const pid_t child = forked([&] {
    const RunLock lock(run_);
    locked.say();
    for (;;) ::pause();
    return kBroken;
  });
  ASSERT_TRUE(locked.wait());
  EXPECT_NE(refusal(run_).find(" process " + std::to_string(child) + " "), std::string::npos);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(run_ / RunLock::kFile)) << "this shows nothing";
  const RunLock lock(run_);
  EXPECT_NE(refusal(run_).find(" process " + std::to_string(::getpid()) + " "), std::string::npos);
}

TEST_F(RunLockOf, ATaskIsThatOfTheJointRun) {
  const fs::path task = run_ / "tasks" / "pace";
  for (const fs::path& run : {run_, task}) write_run_json(run);
  {
    const RunLock lock(task);
    EXPECT_EQ(lock.folder(), fs::canonical(run_));
    EXPECT_NE(refusal(run_), "");
  }
  const RunLock lock(run_);
  EXPECT_NE(refusal(task), "");
}

TEST_F(RunLockOf, AFolderThatWasRemovedIsNotThatOfTheNextOne) {
  write_run_json(run_);
  {
    const RunLock gone(run_);
    fs::remove_all(run_);
    EXPECT_FALSE(gone.stands());
    write_run_json(run_);
    EXPECT_EQ(refusal(run_), "");
    const RunLock lock(run_);
    EXPECT_FALSE(gone.stands());
    EXPECT_TRUE(lock.stands());
  }
  write_run_json(run_);
  auto gone = std::make_unique<RunLock>(run_);
  fs::remove_all(run_);
  write_run_json(run_);
  const RunLock lock(run_);
  gone.reset();
  EXPECT_TRUE(lock.stands()) << "its file went with the other's";
}

TEST_F(RunLockOf, ARunIsFoundFromWhatLiesInIt) {
  write_run_json(run_);
  EXPECT_EQ(run_around(run_ / "result/new/deep"), fs::canonical(run_));
  EXPECT_EQ(run_around(run_), fs::canonical(run_));
  EXPECT_EQ(run_around(folder_.path() / "elsewhere"), std::nullopt);
}

/// Fills a run with its own number, once all others were refused.
int compete(const fs::path& run, bool force, Pipe& start, Pipe& told, Pipe& all_told) {
  start.close_write();
  all_told.close_write();
  start.wait();
  try {
    const ResultFolder folder = ResultFolder::create(run, force);
    told.say();
    const std::string mine = std::to_string(::getpid());
    for (const fs::path& file : {folder.inputs() / "task.toml", folder.root() / "events.jsonl",
                                 folder.iterations() / "scene.xml"})
      write_file(file, mine, Durability::process);
    all_told.wait();
    write_json(folder.run_json(), {{"schema", "legwright/run"}, {"who", mine}},
               Durability::process);
    fs::create_directory(folder.result());
    return folder.stand() ? kWon : kBroken;
  } catch (const IoError& error) {
    told.say();
    return std::string(error.what()).find("in use by process ") != std::string::npos ? kRefused
                                                                                     : kBroken;
  } catch (...) {
    told.say();
    return kBroken;
  }
}

TEST_F(RunLockOf, EightWritersAreOneThatWinsAndSevenThatAreRefused) {
  constexpr int kWriters = 8, kRounds = 100;
  for (int round = 0; round < kRounds; ++round) {
    SCOPED_TRACE(round);
    if (round % 5 == 0) fs::remove_all(run_);  // else the run of the round before is replaced
    Pipe start, told, all_told;
    std::vector<pid_t> writers;
    for (int k = 0; k < kWriters; ++k)
      writers.push_back(forked([&] { return compete(run_, true, start, told, all_told); }));
    start.close_write();
    for (int k = 0; k < kWriters; ++k) EXPECT_TRUE(told.wait());
    all_told.close_write();
    pid_t winner = 0;
    for (const pid_t writer : writers) {
      int status = 0;
      ::waitpid(writer, &status, 0);
      ASSERT_TRUE(WIFEXITED(status));
      if (WEXITSTATUS(status) == kWon) {
        EXPECT_EQ(winner, 0) << "two have won";
        winner = writer;
      } else {
        EXPECT_EQ(WEXITSTATUS(status), kRefused);
      }
    }
    ASSERT_NE(winner, 0);
    const std::string mine = std::to_string(winner);
    for (const char* file : {"inputs/task.toml", "events.jsonl", "iterations/scene.xml"})
      EXPECT_EQ(read_file(run_ / file), mine) << file;
    EXPECT_EQ(read_json(run_ / "run.json")["who"], mine);
    EXPECT_FALSE(fs::exists(run_ / RunLock::kFile));
  }
  test::tell_tries("writers of one folder at a time", kWriters * kRounds);
}

}  // namespace
}  // namespace legwright
