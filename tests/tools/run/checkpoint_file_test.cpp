// SPDX-License-Identifier: Apache-2.0
#include "tools/run/checkpoint_file.hpp"

#include <gtest/gtest.h>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

class CheckpointFileTest : public testing::Test {
 protected:
  CheckpointFileTest() {
    begin_.folder = "/somewhere";
    begin_.options.of("task") = "\"task.toml\"";
    begin_.versions.of("legwright") = "0";
    begin_.factor = "avx2";
    begin_.inputs.of("inputs/task.toml") = "01234567";
  }
  const fs::path& run() const { return folder_.path(); }
  fs::path states() const { return checkpoint_folder(run()) / "states.bin"; }

  test::TemporaryFolder folder_;
  CheckpointBegin begin_;
};

TEST_F(CheckpointFileTest, ReadsWhatWasKeptLast) {
  EXPECT_FALSE(read_checkpoint(run()));
  {
    CheckpointFile file(run(), begin_, {});
    file.keep("a/0", {1.0, -0.0, 1e-300});
    file.keep("b", {});
    file.keep("a/0", {2.0});
    EXPECT_TRUE(file.find("a/0").empty()) << "of this process, not of one before it";
  }
  const auto read = read_checkpoint(run());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->begin.folder, "/somewhere");
  EXPECT_EQ(read->begin.options, begin_.options);
  EXPECT_EQ(read->begin.factor, "avx2");
  EXPECT_EQ(*read->begin.inputs.find("inputs/task.toml"), "01234567");
  EXPECT_EQ(read->states, (CheckpointStates{{"a/0", {2.0}}, {"b", {}}}));

  CheckpointFile next(run(), begin_, read->states);
  EXPECT_EQ(next.find("a/0"), std::vector<double>{2.0});
  next.keep("c", {3.0});
  EXPECT_EQ(read_checkpoint(run())->states.size(), 3U) << "earlier ones are there, too";
  next.remove();
  EXPECT_FALSE(read_checkpoint(run()));
  EXPECT_FALSE(fs::exists(checkpoint_folder(run())));
}

TEST_F(CheckpointFileTest, WhatIsTornOrDamagedEndsIt) {
  std::size_t first = 0;
  {
    CheckpointFile file(run(), begin_, {});
    file.keep("a", {1.0, 2.0});
    first = fs::file_size(states());
    file.keep("b", {3.0});
  }
  const std::string whole = read_file(states());
  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
    write_file(states(), whole.substr(0, bytes));
    EXPECT_EQ(read_checkpoint(run())->states.size(), bytes < first ? 0U : 1U) << bytes;
    std::string damaged = whole;
    damaged[bytes] = static_cast<char>(damaged[bytes] ^ 0x10);
    write_file(states(), damaged);
    EXPECT_EQ(read_checkpoint(run())->states.size(), bytes < first ? 0U : 1U) << bytes;
  }
  fs::remove(states());
  EXPECT_TRUE(read_checkpoint(run())->states.empty());
  write_file(checkpoint_folder(run()) / "begin.json", "{}");
  EXPECT_THROW((void)read_checkpoint(run()), IoError);
}

TEST_F(CheckpointFileTest, SupersededStatesDoNotFillTheDisk) {
  CheckpointFile file(run(), begin_, {});
  const std::vector<double> large(1 << 20, 0.5);  // 8 MiB
  std::uintmax_t most = 0;
  for (int k = 0; k < 30; ++k) {
    file.keep("a", large);
    most = std::max(most, fs::file_size(states()));
  }
  file.keep("b", {1.0});
  EXPECT_LT(most, 100U << 20);
  EXPECT_EQ(read_checkpoint(run())->states, (CheckpointStates{{"a", large}, {"b", {1.0}}}));
}

TEST_F(CheckpointFileTest, TellsInputsApart) {
  fs::create_directories(run() / "inputs/meshes");
  write_file(run() / "inputs/robot.xml", "<mujoco/>");
  write_file(run() / "inputs/meshes/a.stl", "solid");
  const auto before = sums_of_inputs(run());
  ASSERT_EQ(before.size(), 2U);
  EXPECT_EQ(before[0].first, "inputs/meshes/a.stl");
  EXPECT_EQ(sums_of_inputs(run()), before);
  write_file(run() / "inputs/meshes/a.stl", "solid ");
  EXPECT_NE(sums_of_inputs(run()), before);
}

}  // namespace
}  // namespace legwright
