// SPDX-License-Identifier: Apache-2.0
#include "tools/run/scene_sums.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

class SceneSums : public testing::Test {
 protected:
  /// A scene that holds its own name.
  void put(const std::string& design, const std::string& more = "") const {
    fs::create_directories(root_ / design);
    write_file(root_ / design / "scene.xml", design + more);
  }
  void put_run(const std::string& place, const RunRecord& run) const {
    fs::create_directories(root_ / place);
    write_json(root_ / place / "run.json", json_of(run));
  }
  static RunRecord of_one_task() {
    RunRecord run;
    run.status = "running";
    run.task.emplace();
    return run;
  }
  /// The refusal of a scene, or nothing.
  std::string refusal(const RunRecord& run, const std::string& design) const {
    try {
      check_scene(root_, run, design);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  static std::vector<std::string> names(const RunRecord& run) {
    std::vector<std::string> out;
    for (const auto& [name, sum] : *run.scenes) out.push_back(name);
    return out;
  }

  const test::TemporaryFolder folder_;
  const fs::path root_ = folder_.path() / "run";
};

TEST_F(SceneSums, AreOfEveryDesignOfTheRunAndOfNothingElse) {
  RunRecord run = of_one_task();
  put_run("", run);
  for (const char* design : {"iterations/0000", "iterations/0003", "result", "candidates/01",
                             "iterations/.0004.1.tmp", "exports/mine", ".result-picked"})
    put(design);
  note_scenes(ResultFolder::open(root_), run);
  EXPECT_EQ(names(run),
            (std::vector<std::string>{"candidates/01/scene.xml", "iterations/0000/scene.xml",
                                      "iterations/0003/scene.xml", "result/scene.xml"}));
}

TEST_F(SceneSums, AnEditedSceneIsRefusedWithWhatToDoInstead) {
  RunRecord run = of_one_task();
  put_run("", run);
  for (const char* design : {"iterations/0000", "result"}) put(design);
  note_scenes(ResultFolder::open(root_), run);
  put_run("", run);
  EXPECT_EQ(refusal(run, "result"), "");
  EXPECT_NO_THROW(check_scenes(root_));
  put("result", " of other masses");
  const std::string told = refusal(run, "result");
  for (const std::string& part :
       {(root_ / "result/scene.xml").string() + ": was edited since the run wrote it",
        std::string("the file of the robot or of the task and run `legwright optimize` again"),
        std::string("`legwright play` shows an edited scene"), std::string("`legwright pick`")})
    EXPECT_NE(told.find(part), std::string::npos) << told;
  EXPECT_THROW(check_result_scenes(root_, run), InputError);
  EXPECT_THROW(check_scenes(root_), InputError);
  EXPECT_EQ(refusal(run, "iterations/0000"), "");

  note_result_scene(root_, run);  // another design was picked
  EXPECT_EQ(refusal(run, "result"), "");
  EXPECT_EQ(names(run).size(), 2U);
}

TEST_F(SceneSums, WhatARunDoesNotKnowPasses) {
  RunRecord run = of_one_task();
  put("result");
  EXPECT_EQ(refusal(run, "result"), "") << "of an older program";
  run.scenes.emplace().of("iterations/0000/scene.xml") = "0123";
  EXPECT_EQ(refusal(run, "result"), "");
  EXPECT_EQ(refusal(run, "iterations/0000"), "") << "is not there any more";
}

TEST_F(SceneSums, OfSeveralTasksEachHasItsOwn) {
  RunRecord run;
  run.status = "running";
  run.tasks.emplace(1).front().name = "pace";
  run.tasks->front().folder = "tasks/pace";
  put_run("", run);
  put_run("tasks/pace", of_one_task());
  for (const char* design : {"tasks/pace/result", "tasks/pace/iterations/0000",
                             "starts/from-pace/pace/iterations/0000", "front/00/pace"})
    put(design);
  note_scenes(ResultFolder::open(root_), run);
  EXPECT_EQ(names(run),
            (std::vector<std::string>{"front/00/pace/scene.xml",
                                      "starts/from-pace/pace/iterations/0000/scene.xml"}));
  EXPECT_EQ(names(read_record_file<RunRecord>(root_ / "tasks/pace/run.json")),
            (std::vector<std::string>{"iterations/0000/scene.xml", "result/scene.xml"}));
  EXPECT_NO_THROW(check_result_scenes(root_, run));
  put("tasks/pace/result", " edited");
  EXPECT_THROW(check_result_scenes(root_, run), InputError);
  EXPECT_EQ(refusal(run, "tasks/pace/iterations/0000"), "");
  EXPECT_EQ(refusal(run, "front/00/pace"), "");
  put("starts/from-pace/pace/iterations/0000", " edited");
  EXPECT_NE(refusal(run, "starts/from-pace/pace/iterations/0000"), "");
}

}  // namespace
}  // namespace legwright
