// SPDX-License-Identifier: Apache-2.0
// A run is replaced when the new one stands, and not before.
#include "tools/run/run_build.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <map>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/checkpoint_file.hpp"
#include "tools/run/own_files.hpp"
#include "tools/run/result_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

void put(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  write_file(file, text, Durability::process);
}

/// A run whose files hold one word.
void fill(const ResultFolder& folder, const std::string& word) {
  write_json(folder.run_json(), {{"schema", "legwright/run"}, {"word", word}}, Durability::process);
  put(folder.events(), word);
  put(folder.inputs() / "robot.xml", "<mujoco><asset><mesh file='meshes/a.stl'/></asset></mujoco>");
  put(folder.inputs() / "meshes/a.stl", "mesh");
  put(folder.result() / "scene.xml", word);
}

class RunBuildOf : public testing::Test {
 protected:
  RunBuildOf() { fill(ResultFolder::create(run_, false), "old"); }

  /// What a folder holds, without locks.
  static std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && entry.path().filename() != RunLock::kFile)
        out[fs::relative(entry.path(), folder).string()] = read_file(entry.path());
    return out;
  }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }
  std::string refusal() const {
    try {
      ResultFolder::create(run_, true);
    } catch (const IoError& error) {
      return error.what();
    }
    return "";
  }

  const test::TemporaryFolder folder_;
  const fs::path run_ = folder_.path() / "run";
};

TEST_F(RunBuildOf, ARunLeavesTheOldOneUntilItStands) {
  const auto before = contents(run_);
  {
    const ResultFolder folder = ResultFolder::create(run_, true);
    EXPECT_NE(folder.root(), run_);
    EXPECT_EQ(folder.root().parent_path(), fs::canonical(folder_.path()));
    EXPECT_EQ(folder.in_the_end(folder.result()), run_ / "result");
    EXPECT_EQ(build_beside(run_), folder.root());
    fill(folder, "new");
    EXPECT_EQ(contents(run_), before);
    EXPECT_TRUE(folder.stand());
    EXPECT_EQ(folder.root(), run_);
    EXPECT_EQ(read_file(run_ / "result/scene.xml"), "new");
    EXPECT_EQ(build_beside(run_), std::nullopt);
    EXPECT_THROW(RunLock{run_}, IoError) << "it is still being written";
    EXPECT_NO_THROW(folder.check_there());
  }
  EXPECT_EQ(entries(), 1U) << "the old one is still there";
  EXPECT_FALSE(fs::exists(run_ / RunLock::kFile));
}

TEST_F(RunBuildOf, ARunThatIsGivenUpOrHasNoResultLeavesTheOldOne) {
  const auto before = contents(run_);
  fill(ResultFolder::create(run_, true), "given up");
  EXPECT_EQ(contents(run_), before);
  {
    const ResultFolder folder = ResultFolder::create(run_, true);
    fill(folder, "new");
    fs::remove_all(folder.result());
    EXPECT_FALSE(folder.stand());
  }
  EXPECT_EQ(contents(run_), before);
  EXPECT_EQ(entries(), 1U);
}

TEST_F(RunBuildOf, ARunThatWasKilledIsSweptByTheNextOne) {
  const auto before = contents(run_);
  const pid_t child = ::fork();
  if (child == 0) {
    const ResultFolder folder = ResultFolder::create(run_, true);
    fill(folder, "killed");
    put(run_ / "result" / ".verdict.json.0123456789abcdef.tmp", "half");
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(entries(), 2U) << "this shows nothing";
  EXPECT_EQ(build_beside(run_), std::nullopt) << "nobody builds it any more";
  fs::remove(run_ / "result" / ".verdict.json.0123456789abcdef.tmp");
  EXPECT_EQ(contents(run_), before);
  fs::create_directory(folder_.path() / ".run.mine.tmp");
  const ResultFolder folder = ResultFolder::create(run_, true);
  EXPECT_EQ(entries(), 3U) << "the run, what is built, and a folder of another name";
}

TEST_F(RunBuildOf, TemporaryFilesOfAKilledWriterAreSwept) {
  const fs::path left = run_ / "result" / ".verdict.json.0123456789abcdef.tmp",
                 own = run_ / "result" / ".mine.tmp";
  for (const fs::path& file : {left, own}) put(file, "half");
  EXPECT_NO_THROW(ResultFolder::open(run_));
  EXPECT_TRUE(fs::exists(left)) << "a reader removes nothing";
  (void)ResultFolder::open_to_write(run_);
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(own));
}

TEST_F(RunBuildOf, SomebodysOwnFilesAreNamedAndKept) {
  for (const char* file : {"notes.txt", "result/thesis.tex", "mine/a", "iterations/0000/b.png"}) {
    put(run_ / file, "years of work");
    const std::string told = refusal(),
                      named = fs::path(file).begin()->string() == "mine" ? "mine" : file;
    EXPECT_NE(told.find("holds files that are not of the run: " + named + "; move them"),
              std::string::npos)
        << told;
    EXPECT_EQ(read_file(run_ / file), "years of work");
    fs::remove(run_ / file);
    if (named == "mine") fs::remove(run_ / "mine");
  }
  fs::create_symlink("/etc/hostname", run_ / "result" / "scene.xml.link");
  EXPECT_NE(refusal().find("result/scene.xml.link"), std::string::npos);
  fs::remove(run_ / "result" / "scene.xml.link");
  for (int k = 0; k < 7; ++k) put(run_ / ("note" + std::to_string(k)), "");
  EXPECT_NE(refusal().find("note4 and 2 more;"), std::string::npos) << refusal();
  EXPECT_EQ(entries(), 1U);
}

TEST_F(RunBuildOf, WhatBelongsToARunIsNobodysOwn) {
  for (const char* file :
       {"report.html", "compare_other.html", "result/meshes/a.stl", "result/summary.md",
        "result/still_0.25.png", "result/validation_drake.json", "iterations/0000/frame.png",
        "tasks/trot/report.html", "tasks/trot/result/meshes/a.stl", "inputs/LICENSE",
        "starts/from-a/trot/iterations/0000/meshes/a.stl", "iterations/.0001.1.0.tmp/any",
        "result/LICENSE", "candidates/03/tightened.toml"})
    put(run_ / file, "ours");
  EXPECT_EQ(own_files_in(run_), std::vector<std::string>{});
  put(run_ / "result/meshes/b.stl", "whose?");
  EXPECT_EQ(own_files_in(run_), std::vector<std::string>{"result/meshes/b.stl"});
  put(run_ / "inputs/robot.xml", "<mujoco>");
  EXPECT_EQ(own_files_in(run_), std::vector<std::string>{}) << "nobody knows";
}

TEST_F(RunBuildOf, AFolderThatGoesAwayMeanwhileEndsTheRun) {
  for (const bool replaces : {true, false}) {
    const fs::path run = replaces ? run_ : folder_.path() / "fresh";
    const ResultFolder folder = ResultFolder::create(run, replaces);
    EXPECT_NO_THROW(folder.check_there());
    fill(folder, "new");
    fs::remove_all(run);
    try {
      folder.check_there();
      ADD_FAILURE() << replaces;
    } catch (const IoError& error) {
      EXPECT_NE(std::string(error.what()).find("was removed or replaced while it was written"),
                std::string::npos)
          << error.what();
    }
    if (replaces) {
      EXPECT_THROW((void)folder.stand(), IoError);
    }
  }
}

/// Keeps one state of a search in a run.
void keep(const fs::path& run, double number) { CheckpointFile(run, {}, {}).keep("a", {number}); }
double kept(const fs::path& run) { return read_checkpoint(run)->states.at("a").at(0); }

TEST_F(RunBuildOf, AGivenUpBuildLeavesItsCheckpointToTheRunIfItIsWhole) {
  keep(ResultFolder::create(run_, true).root(), 1.0);
  EXPECT_EQ(kept(run_), 1.0);
  keep(ResultFolder::create(run_, true).root(), 2.0);
  EXPECT_EQ(kept(run_), 2.0);
  {
    const ResultFolder torn = ResultFolder::create(run_, true);
    put(checkpoint_folder(torn.root()) / "states.bin", "");  // as a full disk leaves it
  }
  EXPECT_EQ(kept(run_), 2.0);
  EXPECT_EQ(own_files_in(run_), std::vector<std::string>{});
  EXPECT_EQ(entries(), 1U);
}

TEST_F(RunBuildOf, TheCheckpointOfAKilledBuildIsRescuedWhereItIsNewerAndNobodyWrites) {
  keep(run_, 1.0);
  const pid_t child = ::fork();
  if (child == 0) {
    keep(ResultFolder::create(run_, true).root(), 2.0);
    const ResultFolder folder = ResultFolder::create(run_, true);
    keep(folder.root(), 3.0);
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  {
    const RunLock somebody(run_);
    rescue_checkpoint(run_);
    EXPECT_EQ(kept(run_), 2.0);
  }
  const fs::path states = checkpoint_folder(run_) / "states.bin";
  const auto then = fs::last_write_time(states);
  fs::last_write_time(states, then + std::chrono::hours(1));
  rescue_checkpoint(run_);
  EXPECT_EQ(kept(run_), 2.0) << "a newer one";
  fs::last_write_time(states, then - std::chrono::hours(1));
  rescue_checkpoint(run_);
  EXPECT_EQ(kept(run_), 3.0);
}

TEST_F(RunBuildOf, ALinkToARunLeadsToTheNewOne) {
  const fs::path link = folder_.path() / "latest";
  fs::create_directory_symlink(run_, link);
  {
    const ResultFolder folder = ResultFolder::create(link, true);
    fill(folder, "new");
    EXPECT_TRUE(folder.stand());
  }
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(read_file(run_ / "result/scene.xml"), "new");
}

TEST_F(RunBuildOf, AFolderInWhichSomebodyWorksIsNotTakenAway) {
  const fs::path before = fs::current_path();
  fs::current_path(run_ / "result");
  EXPECT_NE(refusal().find("is the folder in which this process works"), std::string::npos);
  fs::current_path(before);
  EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace legwright
