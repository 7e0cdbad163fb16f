// SPDX-License-Identifier: Apache-2.0
// A robot as many are published, with its files beside the folder of its main file: every verb
// reads it, and what is written stands for itself.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <map>

#include "mjcf/text/mujoco_pointers.hpp"
#include "mjcf/write/model_diff.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/support/paths.hpp"
#include "tests/tools/verbs/program.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/json_file.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::Outcome;

ModelPointer opened(const fs::path& file) {
  static const bool loaded = [] {
    mj_loadPluginLibrary((test::binary_dir() + "/bin/mujoco_plugin/liblegwright.so").c_str());
    return true;
  }();
  EXPECT_TRUE(loaded);
  char error[1000] = "";
  ModelPointer model(mj_loadXML(file.c_str(), nullptr, error, sizeof error));
  EXPECT_TRUE(model) << file << ": " << error;
  return model;
}

std::string meshes_of(const mjModel& model) {
  return {reinterpret_cast<const char*>(model.mesh_vert),
          sizeof(float) * 3 * static_cast<std::size_t>(model.nmeshvert)};
}

class GatheredRun : public testing::Test, protected test::CallsInFolder {
 protected:
  GatheredRun() { write_package("pkg"); }
  void write_package(const std::string& name) const {
    const fs::path robot = test::write_package_puppy(folder_.path() / name);
    fs::copy_file(test::kExamples / "puppy" / "sideways.toml",
                  robot.parent_path() / "sideways.toml");
  }
  void optimize(const std::string& task, const std::string& run,
                const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"optimize",         task, "--plan-only",
                                   "--max-iterations", "2",  "--no-reasons",
                                   "--no-pictures",    "-o", run};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = call(words);
    ASSERT_LE(outcome.code, 1) << outcome.err;
  }
  fs::path at(const std::string& path) const { return folder_.path() / path; }
  std::map<std::string, std::string> contents(const std::string& folder) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(at(folder)))
      if (entry.is_regular_file())
        files[fs::relative(entry.path(), at(folder)).string()] = read_file(entry.path());
    return files;
  }
  /// All MJCF below a folder names files within it, by relative paths.
  void expect_whole(const std::string& folder) const {
    int models = 0;
    for (const auto& [name, bytes] : contents(folder)) {
      if (fs::path(name).extension() != ".xml") continue;
      ++models;
      EXPECT_FALSE(contains(bytes, "\"../")) << folder << "/" << name;
      EXPECT_FALSE(contains(bytes, folder_.path().string())) << folder << "/" << name;
    }
    EXPECT_GE(models, 1) << folder;
  }
};

TEST_F(GatheredRun, EveryVerbReadsItAndTheRunStandsForItself) {
  const std::string robot = "pkg/mjcf/robot.xml";
  const ModelPointer published = opened(at(robot));
  const Outcome init = call({"init", robot, "--json"});
  EXPECT_EQ(init.code, 0) << init.err;
  EXPECT_EQ(Json::parse(init.out)["declared"].size(), 20u);
  EXPECT_EQ(call({"check", "pkg/mjcf/sideways.toml"}).code, 0);
  EXPECT_EQ(call({"diff", robot, robot}).code, 0);
  const auto before = contents("pkg");
  optimize("pkg/mjcf/sideways.toml", "run");
  EXPECT_EQ(contents("pkg"), before) << "the user's files are as they were";
  fs::remove_all(at("pkg"));

  for (const char* folder : {"run/inputs", "run/iterations/0000", "run/result"}) {
    expect_whole(folder);
    const ModelPointer model = opened(at(folder) / "robot.xml");
    ASSERT_TRUE(model);
    EXPECT_TRUE(meshes_of(*model) == meshes_of(*published)) << folder;
  }
  const ModelPointer initial = opened(at("run/inputs/robot.xml"));
  EXPECT_TRUE(model_differences(*published, *initial, 0.0).empty());
  const ModelPointer scene = opened(at("run/result/scene.xml"));
  EXPECT_TRUE(meshes_of(*scene) == meshes_of(*published));
  // What is summed is what is there.
  const Json sums = read_json(at("run/run.json"))["sha256"];
  for (const char* name :
       {"robot.xml", "common/front_left.xml", "common/shank.xml", "meshes/ear.stl",
        "meshes/nose.obj", "meshes/nose-2.obj", "textures/fur.png"})
    EXPECT_EQ(sums[name], sha256_hex(read_file(at("run/inputs") / name))) << name;

  const Outcome validate = call({"validate", "run", "--quick", "--confined"});
  EXPECT_LE(validate.code, 1) << validate.err;
  EXPECT_TRUE(fs::exists(at("run/result/verdict.json"))) << validate.err;
  const Outcome exported = call({"export", "run", "-o", "mine", "--no-picture", "--confined"});
  EXPECT_LE(exported.code, 1) << exported.err;
  expect_whole("mine");
  const ModelPointer plain = opened(at("mine/puppy.xml"));
  ASSERT_TRUE(plain);
  EXPECT_TRUE(meshes_of(*plain) == meshes_of(*published));
  EXPECT_EQ(call({"diff", "mine/puppy.xml", "run/result/robot.xml", "--confined"}).code, 0);

  // The inputs are a task like any other, and are found within their folder.
  optimize("run/inputs/task.toml", "rerun", {"--confined"});
  EXPECT_EQ(contents("rerun/iterations"), contents("run/iterations"));
  EXPECT_EQ(contents("rerun/inputs"), contents("run/inputs"));
}

/// Where the user keeps the robot leaves no trace.
TEST_F(GatheredRun, SameInputSameBytes) {
  write_package("elsewhere/on/the/disk");
  optimize("pkg/mjcf/sideways.toml", "a");
  optimize("elsewhere/on/the/disk/mjcf/sideways.toml", "b");
  for (const char* folder : {"inputs", "iterations", "result"})
    EXPECT_EQ(contents(std::string("a/") + folder), contents(std::string("b/") + folder)) << folder;
  EXPECT_EQ(read_json(at("a/run.json"))["sha256"], read_json(at("b/run.json"))["sha256"]);
}

TEST_F(GatheredRun, InitWritesTheWholeRobotElsewhere) {
  std::string dog = read_file(at("pkg/mjcf/robot.xml"));
  const std::size_t begin = dog.find("  <custom>"), end = dog.find("</custom>\n");
  write_file(at("pkg/mjcf/robot.xml"), dog.erase(begin, end + 10 - begin));
  const ModelPointer published = opened(at("pkg/mjcf/robot.xml"));
  const Outcome init =
      call({"init", "pkg/mjcf/robot.xml", "-o", "mine/dog.xml", "--task", "mine/trot.toml"});
  EXPECT_EQ(init.code, 0) << init.err;
  expect_whole("mine");
  // In place nothing is gathered: the user's file keeps its paths.
  EXPECT_EQ(call({"init", "pkg/mjcf/robot.xml", "--write"}).code, 0);
  EXPECT_TRUE(contains(read_file(at("pkg/mjcf/robot.xml")), "meshdir=\"../meshes\""));
  EXPECT_FALSE(fs::exists(at("pkg/mjcf/common")));
  fs::remove_all(at("pkg"));
  const ModelPointer written = opened(at("mine/dog.xml"));
  ASSERT_TRUE(written);
  EXPECT_TRUE(meshes_of(*written) == meshes_of(*published));
  EXPECT_EQ(call({"check", "mine/trot.toml", "--confined"}).code, 0);

  // What is there already stays; nothing is replaced, and nothing is written through a link.
  write_package("pkg");
  EXPECT_EQ(call({"init", "pkg/mjcf/robot.xml", "-o", "mine/twice.xml"}).code, 0);
  ASSERT_TRUE(opened(at("mine/twice.xml")));
  write_file(at("mine/common/defaults.xml"), read_file(at("mine/common/defaults.xml")) + " ");
  const auto before = contents("mine");
  const Outcome again = call({"init", "pkg/mjcf/robot.xml", "-o", "mine/other.xml"});
  EXPECT_EQ(again.code, 3) << again.err;
  EXPECT_TRUE(contains(again.err, "mine/common/defaults.xml: another file is there")) << again.err;
  EXPECT_EQ(contents("mine"), before);
  fs::create_directories(at("linked"));
  fs::create_directories(at("target"));
  fs::create_directory_symlink(at("target"), at("linked/textures"));
  const Outcome linked = call({"init", "pkg/mjcf/robot.xml", "-o", "linked/dog.xml"});
  EXPECT_EQ(linked.code, 3) << linked.err;
  EXPECT_TRUE(contains(linked.err, "linked/textures: is a symbolic link")) << linked.err;
  EXPECT_TRUE(fs::is_empty(at("target")));
  EXPECT_FALSE(fs::exists(at("linked/dog.xml")));
}

TEST_F(GatheredRun, ConfinedVerbsRefuseItAndWriteNothing) {
  const std::string robot = "pkg/mjcf/robot.xml", task = "pkg/mjcf/sideways.toml";
  const auto before = contents("pkg");
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"init", robot, "--write"},
                                             {"init", robot, "-o", "mine/dog.xml"},
                                             {"check", task},
                                             {"check", task, "--gradients"},
                                             {"diff", robot, robot},
                                             {"optimize", task, "-o", "run"}}) {
    std::vector<std::string> confined = words;
    confined.emplace_back("--confined");
    const Outcome outcome = call(confined);
    EXPECT_EQ(outcome.code, 2) << words[0] << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "robot.xml:")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err,
                         "'../common/defaults.xml' lies at " +
                             fs::canonical(at("pkg/common/defaults.xml")).string() +
                             ", outside of the folder of the robot's main file, and --confined "
                             "was given: copy it into that folder"))
        << outcome.err;
  }
  EXPECT_EQ(contents("pkg"), before);
  EXPECT_FALSE(fs::exists(at("run")));
  EXPECT_FALSE(fs::exists(at("mine")));
}

/// A run that somebody else has made, or changed.
TEST_F(GatheredRun, ConfinedVerbsRefuseARunThatLeadsOut) {
  optimize("pkg/mjcf/sideways.toml", "run");
  const std::vector<std::vector<std::string>> verbs{{"validate", "run", "--quick"},
                                                    {"export", "run", "-o", "mine"},
                                                    {"pick", "run", "--iteration", "0"},
                                                    {"render", "run", "--small"},
                                                    {"report", "run"},
                                                    {"report", "run", "run"},
                                                    {"play", "run", "--print"}};
  const auto expect_refused = [&](const std::string& why) {
    const auto before = contents("run");
    for (std::vector<std::string> words : verbs) {
      words.emplace_back("--confined");
      const Outcome outcome = call(words);
      EXPECT_EQ(outcome.code, 2) << words[0] << outcome.err;
      EXPECT_TRUE(contains(outcome.err, why)) << words[0] << outcome.err;
    }
    EXPECT_EQ(contents("run"), before);
    EXPECT_FALSE(fs::exists(at("mine")));
  };
  const std::string scene = read_file(at("run/result/scene.xml"));
  write_file(at("run/result/scene.xml"),
             test::with(scene, "\"meshes/ear.stl\"", "\"../../pkg/meshes/ear.stl\""));
  expect_refused("--confined was given");
  write_file(at("run/result/scene.xml"), scene);
  fs::create_symlink(at("pkg/meshes/ear.stl"), at("run/result/link.stl"));
  expect_refused("run/result/link.stl: is a symbolic link, which no run has");
  fs::remove(at("run/result/link.stl"));
  EXPECT_EQ(call({"pick", "run", "--iteration", "0", "--confined"}).code, 0);
}

TEST_F(GatheredRun, ThePageOfTwoRunsIsNotWrittenThroughALink) {
  optimize("pkg/mjcf/sideways.toml", "run");
  write_file(at("mine.txt"), "mine\n");
  fs::create_symlink(at("mine.txt"), at("run/compare_run.html"));
  const Outcome linked = call({"report", "run", "run"});
  EXPECT_EQ(linked.code, 2) << linked.err;
  EXPECT_TRUE(contains(linked.err, "run/compare_run.html: is a symbolic link")) << linked.err;
  EXPECT_EQ(read_file(at("mine.txt")), "mine\n");
  fs::remove(at("run/compare_run.html"));
  EXPECT_EQ(call({"report", "run", "run"}).code, 0);
}

TEST_F(GatheredRun, WhatIsNoFileIsRefusedWithWhatItIs) {
  fs::remove(at("pkg/meshes/ear.stl"));
  ASSERT_EQ(::mkfifo(at("pkg/meshes/ear.stl").c_str(), 0600), 0);
  const auto refusal = [&] {
    const Outcome outcome = call({"check", "pkg/mjcf/sideways.toml"});
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    return outcome.err;
  };
  EXPECT_TRUE(contains(refusal(), "mesh 'ear': the file '../meshes/ear.stl' is a pipe"));
  fs::remove(at("pkg/meshes/ear.stl"));
  fs::create_symlink("/dev/zero", at("pkg/meshes/ear.stl"));
  EXPECT_TRUE(contains(refusal(), "is a device"));
  fs::remove(at("pkg/meshes/ear.stl"));
  fs::create_symlink("ear.stl", at("pkg/meshes/ear.stl"));
  EXPECT_TRUE(contains(refusal(), "Too many levels of symbolic links"));
  fs::remove(at("pkg/meshes/ear.stl"));
  fs::create_symlink("../spare.stl", at("pkg/meshes/ear.stl"));
  test::put(at("pkg/spare.stl"), test::tetrahedron_stl(0.03f));
  EXPECT_EQ(call({"check", "pkg/mjcf/sideways.toml"}).code, 0);
}

}  // namespace
}  // namespace legwright
