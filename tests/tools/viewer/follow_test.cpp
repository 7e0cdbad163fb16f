// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/follow.hpp"
#include "tests/support/paths.hpp"
#include "tools/files/clean_text.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/iteration_record.hpp"
#include "tools/run/result_folder.hpp"
#include "tools/run/run_record.hpp"
#include "tools/viewer/message_lines.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// A design whose files say that they were written `second` seconds after the first.
void land(const fs::path& folder, int second) {
  static const auto begin = fs::file_time_type::clock::now();
  fs::create_directories(folder);
  write_file(folder / "scene.xml", "<mujoco/>");
  fs::last_write_time(folder / "scene.xml", begin + std::chrono::seconds(second));
}

void write_status(const fs::path& run, const char* status) {
  fs::create_directories(run);
  RunRecord record;
  record.status = status;
  record.task.emplace();
  if (record.ended()) {
    const auto fixture = fs::path(test::source_dir()) / "tests/tools/report/data/run.json";
    record = read_record_file<RunRecord>(fixture);
  }
  write_json(run / "run.json", json_of(record));
}

TEST(RunFollower, WaitsShowsEachDesignOnceAndEndsWithTheResult) {
  const TemporaryFolder folder;
  const fs::path run = folder.path() / "run";
  RunFollower follower(run / "");
  EXPECT_FALSE(follower.next());
  EXPECT_EQ(follower.waiting(), "waiting for the first design of " + run.string());
  write_status(run, "running");
  EXPECT_FALSE(follower.next());
  land(run / "iterations" / "0000", 0);
  const auto first = follower.next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->name, "iteration 0");
  EXPECT_EQ(first->scene, run / "iterations" / "0000" / "scene.xml");
  EXPECT_EQ(follower.waiting(), "");
  EXPECT_FALSE(follower.next());
  land(run / "iterations" / "0001", 0);  // by a coarse clock at the same time
  EXPECT_EQ(follower.next()->name, "iteration 1");
  land(run / "result", 1);
  EXPECT_FALSE(follower.next()) << "the run goes on";
  write_status(run, "converged");
  const auto result = follower.next();
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->result && follower.ended());
  EXPECT_EQ(result->name, "result");
  EXPECT_FALSE(follower.next());
}

TEST(RunFollower, PassesOverWhatIsNoDesignYet) {
  const TemporaryFolder folder;
  land(folder.path() / "iterations" / ".0000.tmp", 5);
  land(folder.path() / "iterations" / "notes", 6);
  fs::create_directories(folder.path() / "iterations" / "0003");  // without a scene
  write_file(folder.path() / "run.json", "{\"status\": ");        // half there
  RunFollower follower(folder.path());
  EXPECT_FALSE(follower.next());
  land(folder.path() / "iterations" / "0003", 7);
  EXPECT_EQ(follower.next()->name, "iteration 3");
}

TEST(RunFollower, NoticesThatARunIsMadeAnew) {
  const TemporaryFolder folder;
  const fs::path run = folder.path();
  write_status(run, "converged");
  land(run / "iterations" / "0007", 1);
  land(run / "result", 2);
  RunFollower follower(run);
  EXPECT_TRUE(follower.next()->result);
  fs::remove_all(run / "iterations");
  fs::remove_all(run / "result");
  write_status(run, "running");
  EXPECT_FALSE(follower.next());
  land(run / "iterations" / "0000", 3);
  EXPECT_EQ(follower.next()->name, "iteration 0");
}

TEST(RunFollower, WatchesTheNewRunThatIsBuiltBesideTheOldOne) {
  const TemporaryFolder folder;
  const fs::path run = folder.path() / "run";
  write_status(run, "converged");
  land(run / "iterations" / "0007", 1);
  land(run / "result", 2);
  RunFollower follower(run), of_task(run / "tasks" / "trot");
  EXPECT_TRUE(follower.next()->result);
  {
    const ResultFolder fresh = ResultFolder::create(run, true);
    EXPECT_FALSE(follower.next());
    EXPECT_FALSE(follower.ended());
    write_status(fresh.root(), "running");
    land(fresh.root() / "iterations" / "0000", 3);
    EXPECT_EQ(follower.next()->name, "iteration 0");
    land(fresh.root() / "starts" / "trot-alone" / "trot" / "iterations" / "0004", 4);
    EXPECT_EQ(of_task.next()->name, "iteration 4 trot-alone");
    land(fresh.root() / "result", 5);
    write_status(fresh.root(), "converged");
    ASSERT_TRUE(fresh.stand());
  }
  const auto result = follower.next();
  ASSERT_TRUE(result && result->result && follower.ended());
  EXPECT_EQ(result->scene, run / "result" / "scene.xml");
}

TEST(RunFollower, FollowsATaskOfAJointRunThroughItsStarts) {
  const TemporaryFolder folder;
  const fs::path starts = folder.path() / "starts";
  RunFollower follower(folder.path() / "tasks" / "trot");
  EXPECT_FALSE(follower.next());
  land(starts / "trot-alone" / "trot" / "iterations" / "0004", 1);
  EXPECT_EQ(follower.next()->name, "iteration 4 trot-alone");
  land(starts / "from-initial" / "walk" / "iterations" / "0000", 2);  // of another task
  EXPECT_FALSE(follower.next());
  land(starts / "from-initial" / "trot" / "iterations" / "0000", 3);
  EXPECT_EQ(follower.next()->name, "iteration 0 from-initial");
  const fs::path task = folder.path() / "tasks" / "trot";
  land(task / "iterations" / "0000", 4);  // a copy
  EXPECT_FALSE(follower.next());
  land(task / "result", 5);
  write_status(task, "converged");
  EXPECT_TRUE(follower.next()->result);
}

TEST(RunFollower, NamesTheTasksOfAJointRun) {
  const TemporaryFolder folder;
  RunRecord record;
  record.status = "running";
  TaskRecord& task = record.tasks.emplace().emplace_back();
  task.name = "trot";
  task.folder = "tasks/trot";
  write_json(folder.path() / "run.json", json_of(record));
  RunFollower follower(folder.path());
  EXPECT_FALSE(follower.next());
  EXPECT_NE(follower.waiting().find("play --live " + folder.path().string() + "/tasks/trot"),
            std::string::npos);
}

TEST(Facts, ComeFromTheMetricsAndDoWithoutThem) {
  const TemporaryFolder folder;
  const fs::path design = folder.path() / "0012";
  land(design, 0);
  const WrittenDesign landed = design_at(design / "scene.xml");
  EXPECT_EQ(landed.name, "iteration 12");
  EXPECT_EQ(facts_of(landed).size(), 1u);
  write_file(design / "metrics.json", "[1, 2");
  EXPECT_EQ(facts_of(landed).size(), 1u);
  IterationMetrics metrics;
  metrics.F = 1.25;
  metrics.J = 0.5;
  metrics.speed_reached = 0.09;
  metrics.speed_wanted = 0.1;
  write_json(design / "metrics.json", json_of(metrics));
  const std::vector<Fact> facts = facts_of(landed);
  ASSERT_EQ(facts.size(), 3u);
  EXPECT_EQ(facts[0].value, "iteration 12");
  EXPECT_EQ(facts[1].value, "1.75");
  EXPECT_EQ(facts[2].value, "90 % of wanted");
  EXPECT_TRUE(facts_of(design_at(folder.path() / "scene.xml")).empty());
}

TEST(Words, BreakIntoLinesAndKeepWithinTheSize) {
  EXPECT_EQ(in_lines("short", 100), "short");
  const std::string broken = in_lines(std::string(50, 'a') + " " + std::string(50, 'b'), 1000);
  EXPECT_EQ(broken, std::string(50, 'a') + "\n" + std::string(50, 'b'));
  EXPECT_EQ(in_lines("one\ntwo\tthree", 100), "one\ntwo three");
  const std::string word = in_lines(std::string(130, 'x'), 1000);
  EXPECT_EQ(std::count(word.begin(), word.end(), '\n'), 2);
  EXPECT_EQ(std::count(word.begin(), word.end(), 'x'), 130);
  const std::string cut = in_lines(std::string(500, 'y'), 100);
  EXPECT_EQ(cut.size(), 100u);
  EXPECT_EQ(cut.substr(96), " ...");
}

TEST(Words, AreCutBetweenCharactersOnly) {
  std::string umlauts;
  for (int k = 0; k < 130; ++k) umlauts += "ü";
  const std::string lines = in_lines(umlauts, 1000);
  EXPECT_EQ(lines.find('\n'), 120u) << "60 characters of two bytes";
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 2);
  for (std::size_t size = 0; size < 40; ++size) {
    const std::string cut = in_lines(umlauts, size);
    EXPECT_LE(cut.size(), size);
    EXPECT_EQ(terminal_text(cut), cut) << "half a character is none";
    if (size >= 6) {
      EXPECT_TRUE(cut.ends_with("ü ...")) << cut;
    }
  }
}

TEST(Words, CommandNoTerminal) {
  EXPECT_EQ(terminal_text("größe\nof a\tleg"), "größe\nof a leg");
  for (const char* control : {"\x1b", "\x07", "\x7f", "\xc2\x9b", "\xe2\x80\xae", "\xe2\x81\xa6"}) {
    const std::string name = std::string("a") + control + "[2Jb";
    EXPECT_EQ(terminal_text(name).find(control), std::string::npos) << name;
    EXPECT_EQ(in_lines(name, 100), terminal_text(name));
    EXPECT_TRUE(terminal_text(name).ends_with("[2Jb"));
  }
  EXPECT_EQ(terminal_text("torn \xc3"), "torn \xef\xbf\xbd");
}

TEST(Words, AreNotRepeated) {
  EXPECT_EQ(without_repeats("a\nb\n\na\nb\nc\n"), "a\nb\nc");
  EXPECT_EQ(without_repeats(""), "");
}

}  // namespace
}  // namespace legwright
