// SPDX-License-Identifier: Apache-2.0
#include "tools/run/result_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/io_error.hpp"
#include "tools/files/json_file.hpp"
#include "tools/run/run_lock.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

std::string refusal(const fs::path& root, bool force) {
  try {
    ResultFolder::create(root, force);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

void make_run(const fs::path& root) {
  const ResultFolder folder = ResultFolder::create(root, false);
  write_json(folder.run_json(), {{"schema", "legwright/run"}, {"status", "converged"}});
  write_file(folder.events(), "line\n");
}

TEST(ResultFolder, IsMadeWithItsParents) {
  const TemporaryFolder base;
  const ResultFolder folder = ResultFolder::create(base.path() / "runs" / "puppy-sideways", false);
  EXPECT_TRUE(fs::is_directory(folder.inputs()));
  EXPECT_TRUE(fs::is_directory(folder.iterations()));
  EXPECT_FALSE(fs::exists(folder.result()));
  EXPECT_EQ(folder.iteration(7).filename(), "0007");
  EXPECT_TRUE(fs::exists(folder.root() / RunLock::kFile));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.root()), fs::directory_iterator()), 3);
}

TEST(ResultFolder, RefusesARunUntilForced) {
  const TemporaryFolder base;
  make_run(base.path() / "run");
  const std::string message = refusal(base.path() / "run", false);
  EXPECT_NE(message.find("already holds a run"), std::string::npos) << message;
  EXPECT_NE(message.find("--force"), std::string::npos) << message;
  EXPECT_EQ(read_file(base.path() / "run" / "events.jsonl"), "line\n");
  EXPECT_EQ(refusal(base.path() / "run", true), "");
}

TEST(ResultFolder, ForceKeepsForeignFiles) {
  const TemporaryFolder base;
  make_run(base.path() / "run");
  for (const char* name : {"notes.txt", "summary.md"})
    write_file(base.path() / "run" / name, "mine");
  EXPECT_NE(refusal(base.path() / "run", true).find("not of the run: notes.txt, summary.md;"),
            std::string::npos);
  for (const char* name : {"notes.txt", "summary.md"})
    EXPECT_EQ(read_file(base.path() / "run" / name), "mine");
}

TEST(ResultFolder, NeverRemovesWhatIsNoRun) {
  const TemporaryFolder base;
  fs::create_directories(base.path() / "result");
  write_file(base.path() / "result" / "thesis.tex", "years of work");
  write_file(base.path() / "run.json", "{\"schema\": \"other\"}");
  for (const bool force : {false, true}) EXPECT_NE(refusal(base.path(), force), "");
  EXPECT_EQ(read_file(base.path() / "result" / "thesis.tex"), "years of work");
}

// As a full disk leaves it.
TEST(ResultFolder, TakesARunThatWasBrokenOffBeforeItHadADesign) {
  const TemporaryFolder base;
  const fs::path run = base.path() / "run";
  for (const char* status : {"running", "failed"}) {
    make_run(run);
    write_json(run / "run.json", {{"schema", "legwright/run"}, {"status", status}});
    write_file(run / "inputs/robot.xml", "half");
    fs::create_directories(run / "iterations/.0000");
    write_file(run / "iterations/.0000/robot.xml", "not whole");
    EXPECT_EQ(refusal(run, false), "") << status;
    fs::remove_all(run);
  }
  for (const char* kept : {"iterations/0000/scene.xml", "result/scene.xml"}) {
    make_run(run);
    write_json(run / "run.json", {{"schema", "legwright/run"}, {"status", "running"}});
    fs::create_directories((run / kept).parent_path());
    write_file(run / kept, "a design");
    EXPECT_NE(refusal(run, false).find("already holds a run"), std::string::npos) << kept;
    fs::remove_all(run);
  }
}

TEST(ResultFolder, TakesWhatAKilledProcessHadOnlyBegun) {
  const TemporaryFolder base;
  (void)ResultFolder::create(base.path() / "run", false);  // without run.json
  EXPECT_EQ(refusal(base.path() / "run", false), "");
}

TEST(ResultFolder, RefusesAFileAndAFolderThatCannotBeWritten) {
  const TemporaryFolder base;
  write_file(base.path() / "file", "text");
  EXPECT_NE(refusal(base.path() / "file", true).find("not a folder"), std::string::npos);
  EXPECT_NE(refusal(base.path() / "file" / "below", false).find("cannot be written"),
            std::string::npos);
  // Root may write anywhere but here.
  EXPECT_NE(refusal("/proc/legwright-run", false).find("cannot be written"), std::string::npos);
  if (::geteuid() != 0) {
    fs::permissions(base.path(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_NE(refusal(base.path() / "run", false).find("cannot be written"), std::string::npos);
  }
}

TEST(ResultFolder, OpensOnlyRuns) {
  const TemporaryFolder base;
  EXPECT_THROW(ResultFolder::open(base.path()), IoError);
  EXPECT_THROW(ResultFolder::open(base.path() / "missing"), IoError);
  const auto complaint = [](const fs::path& root) -> std::string {
    try {
      ResultFolder::open(root);
    } catch (const IoError& error) {
      return error.what();
    }
    return "";
  };
  write_file(base.path() / "trot.toml", "robot = 'robot.xml'");
  EXPECT_NE(complaint(base.path() / "trot.toml").find("`legwright optimize`"), std::string::npos);
  write_file(base.path() / "run.json", "{\"schema\":");
  const std::string damaged = complaint(base.path());
  EXPECT_NE(damaged.find("run.json: is damaged"), std::string::npos) << damaged;
  EXPECT_NE(damaged.find("run `legwright optimize`, which writes it again"), std::string::npos);
  make_run(base.path() / "run");
  EXPECT_EQ(ResultFolder::open(base.path() / "run").root(), base.path() / "run");
}

}  // namespace
}  // namespace legwright
