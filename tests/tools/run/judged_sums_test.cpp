// SPDX-License-Identifier: Apache-2.0
#include "tools/run/judged_sums.hpp"

#include <gtest/gtest.h>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/checksum.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/run_record.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// A run of toys: each file holds its own name.
class JudgedSumsOf : public testing::Test {
 protected:
  JudgedSumsOf() { make_run(run_); }

  static void make_run(const fs::path& run) {
    for (const char* file : {"inputs/task.toml", "inputs/robot.xml", "iterations/0000/motion.csv",
                             "iterations/0000/scene.xml", "result/motion.csv", "result/scene.xml"})
      put(run / file, file);
    for (const char* folder : {"iterations/0000", "result"}) {
      put(run / folder / "robot.xml",
          "<mujoco><asset><mesh file='meshes/a.stl'/></asset><include file='leg.xml'/></mujoco>");
      put(run / folder / "leg.xml", "<mujocoinclude><option/></mujocoinclude>");
      put(run / folder / "meshes/a.stl", "mesh");
    }
  }
  static void put(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    write_file(file, text, Durability::process);
  }

  const test::TemporaryFolder folder_;
  const fs::path run_ = folder_.path() / "run";
};

TEST_F(JudgedSumsOf, ARunAreOfAllThatIsPlayed) {
  const JudgedSums sums = sums_of_run(run_);
  EXPECT_EQ(sums.size(), 12U);
  ASSERT_NE(sums.find("result/meshes/a.stl"), nullptr);
  EXPECT_EQ(*sums.find("result/meshes/a.stl"), sha256_hex("mesh"));
  EXPECT_EQ(*sums.find("result/scene.xml"), sha256_hex("result/scene.xml"));
  for (const auto& [file, sum] : sums) {
    SCOPED_TRACE(file);
    const std::string before = read_file(run_ / file);
    write_file(run_ / file, before + " ", Durability::process);
    EXPECT_EQ(standing_of(sums, sums_of_run(run_)), Standing::of_another);
    write_file(run_ / file, before, Durability::process);
    EXPECT_EQ(standing_of(sums, sums_of_run(run_)), Standing::of_this);
    fs::remove(run_ / file);
    EXPECT_EQ(standing_of(sums, sums_of_run(run_)), Standing::of_another);
    write_file(run_ / file, before, Durability::process);
  }
}

TEST_F(JudgedSumsOf, ARunAreNotOfWhatIsMadeOfIt) {
  const JudgedSums sums = sums_of_run(run_);
  for (const char* file : {"run.json", "result/verdict.json", "iterations/0001/scene.xml",
                           "iterations/0000/frame.png"})
    put(run_ / file, "more");
  EXPECT_EQ(sums_of_run(run_), sums);
}

TEST_F(JudgedSumsOf, AResultLeaveTheInitialBodyOut) {
  const JudgedSums sums = sums_of_result(run_);
  EXPECT_EQ(sums.size(), 7U);
  put(run_ / "iterations/0000/scene.xml", "another");
  EXPECT_EQ(sums_of_result(run_), sums);
}

TEST_F(JudgedSumsOf, AJointRunAreThoseOfItsTasksAndOfTheirBodiesAlone) {
  RunRecord run;
  run.tasks.emplace(2);
  for (const std::size_t k : {0, 1}) {
    TaskRecord& task = (*run.tasks)[k];
    task.name = k == 0 ? "pace" : "trot";
    task.folder = "tasks/" + task.name;
    make_run(run_ / *task.folder);
  }
  put(run_ / "starts/from-pace/trot/iterations/0000/scene.xml", "alone");
  const JudgedSums sums = sums_of(run_, run);
  EXPECT_EQ(sums.size(), 25U);
  EXPECT_NE(sums.find("tasks/trot/result/leg.xml"), nullptr);
  EXPECT_NE(sums.find("starts/from-pace/trot/iterations/0000/scene.xml"), nullptr);
}

TEST_F(JudgedSumsOf, LimitsAreNoFile) {
  JudgedSums of = sums_of_run(run_);
  of.of(kLimitsSum) = "of some limits";
  EXPECT_EQ(standing_of(of, sums_of_run(run_)), Standing::of_this);
  EXPECT_EQ(standing_of(std::nullopt, sums_of_run(run_)), Standing::without_sums);
  EXPECT_EQ(standing_of(JudgedSums(), sums_of_run(run_)), Standing::of_another);
}

TEST_F(JudgedSumsOf, ARunThatWasReplacedAreRefused) {
  const JudgedSums before = sums_of_run(run_);
  EXPECT_NO_THROW(check_unchanged(run_, before, sums_of_run(run_)));
  fs::remove_all(run_);
  try {
    check_unchanged(run_, before, sums_of_run(run_));
    FAIL() << "a run that is not there";
  } catch (const IoError& error) {
    EXPECT_EQ(std::string(error.what()),
              run_.string() + ": the run was replaced meanwhile: judge again");
  }
}

TEST_F(JudgedSumsOf, BytesHaveTheirNames) {
  const JudgedSums with{{"metrics.json", sha256_hex("result/scene.xml")}};
  EXPECT_TRUE(names_bytes(with, "metrics.json", run_ / "result/scene.xml"));
  EXPECT_FALSE(names_bytes(with, "metrics.json", run_ / "result/motion.csv"));
  EXPECT_FALSE(names_bytes(with, "numerics.json", run_ / "result/scene.xml"));
  EXPECT_FALSE(names_bytes(with, "metrics.json", run_ / "result/none"));
}

}  // namespace
}  // namespace legwright
