// SPDX-License-Identifier: Apache-2.0
#include "tools/files/new_files.hpp"

#include <gtest/gtest.h>

#include <system_error>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

TEST(NewFiles, AreWrittenInFoldersThatAreMade) {
  const test::TemporaryFolder folder;
  const fs::path a = folder.path() / "a" / "b" / "x", b = folder.path() / "a" / "y";
  write_new_files({{a, "x"}, {b, "y"}});
  EXPECT_EQ(read_file(a) + read_file(b), "xy");
  EXPECT_THROW(write_new_files({{folder.path() / "z", "z"}, {a, "other"}}), IoError);
  EXPECT_EQ(read_file(a), "x");
  EXPECT_FALSE(fs::exists(folder.path() / "z"));
}

TEST(NewFiles, AreAllThereOrNone) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "file", "");
  fs::create_directory(folder.path() / "kept");
  EXPECT_THROW(write_new_files({{folder.path() / "a" / "b" / "x", "x"},
                                {folder.path() / "kept" / "x", "x"},
                                {folder.path() / "file" / "y", "y"}}),
               std::system_error);
  EXPECT_FALSE(fs::exists(folder.path() / "a"));
  EXPECT_TRUE(fs::is_empty(folder.path() / "kept")) << "it was there before";
}

TEST(NewFiles, OnePlaceHasManyPaths) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "a");
  fs::create_directory_symlink("a", folder.path() / "link");
  fs::create_symlink("gone", folder.path() / "dangling");
  EXPECT_TRUE(same_place(folder.path() / "a" / "x", folder.path() / "link" / ".." / "a" / "x"));
  EXPECT_FALSE(same_place(folder.path() / "a" / "x", folder.path() / "x"));
  EXPECT_THROW(refuse_existing(folder.path() / "dangling"), IoError);
  EXPECT_NO_THROW(refuse_existing(folder.path() / "x"));
}

}  // namespace
}  // namespace legwright
