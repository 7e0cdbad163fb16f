// SPDX-License-Identifier: Apache-2.0
// A folder that is to take another's place holds the same files, and is written beside it.
#include "tools/files/link_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/tools/files/temporary_folder.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/replace_folder.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

class LinkFolder : public testing::Test {
 protected:
  LinkFolder() {
    fs::create_directories(old_ / "below");
    fs::create_directory(fresh_);
    write_file(old_ / "verdict", "old\n");
    write_file(old_ / "below/mesh", "mesh\n");
  }
  const test::TemporaryFolder folder_;
  const fs::path old_ = folder_.path() / "old", fresh_ = folder_.path() / "fresh";
};

TEST_F(LinkFolder, WhatIsWrittenThereIsNotWrittenInTheOther) {
  ASSERT_TRUE(link_folder(old_, fresh_));
  EXPECT_TRUE(fs::equivalent(old_ / "below/mesh", fresh_ / "below/mesh"));
  write_file(fresh_ / "verdict", "new\n");
  EXPECT_EQ(read_file(old_ / "verdict"), "old\n");
  if (!exchange_at_once(fresh_, old_)) GTEST_SKIP() << "the file system exchanges no names";
  EXPECT_EQ(read_file(old_ / "verdict"), "new\n");
  EXPECT_EQ(read_file(old_ / "below/mesh"), "mesh\n");
  EXPECT_EQ(read_file(fresh_ / "verdict"), "old\n");
}

TEST_F(LinkFolder, WhatCouldNotBeRemovedIsRefused) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::permissions(old_ / "below", fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_FALSE(link_folder(old_, fresh_));
  fs::permissions(old_ / "below", fs::perms::owner_all);
}

TEST_F(LinkFolder, AFolderThatIsNotThereIsToldNotMade) {
  EXPECT_FALSE(link_folder(folder_.path() / "none", fresh_));
  EXPECT_THROW((void)exchange_at_once(fresh_, folder_.path() / "none"), std::system_error);
}

}  // namespace
}  // namespace legwright
