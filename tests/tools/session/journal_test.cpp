// SPDX-License-Identifier: Apache-2.0
#include "tools/session/journal.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/session/puppy.hpp"
#include "tools/files/atomic_file.hpp"

namespace legwright {
namespace {

class Journal : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "session.jsonl";
  const SessionBegin begin_ = begin_of(test::puppy(), test::sideways(), test::kSideways);
};

TEST_F(Journal, ComesBackLineByLineAndIsThereAtOnce) {
  SessionJournal journal(begin_, file_);
  EXPECT_EQ(read_journal(file_).begin.text, test::sideways());
  EXPECT_EQ(read_journal(file_).begin.robot_sha256.size(), 64u);
  journal.add(session::Edit{{{"front_thigh_length", 0.1}}});
  journal.add(session::Settled{});
  const ReadJournal read = read_journal(file_);  // while it is open
  ASSERT_EQ(read.commands.size(), 2u);
  EXPECT_EQ(json_of(read.commands[0]), json_of(journal.commands()[0]));
  EXPECT_EQ(journal.text(), read_file(file_));
}

TEST_F(Journal, ASearchThatDiedCountsWithThePointsThatItHad) {
  SessionJournal journal(begin_, file_);
  journal.searching(3);
  journal.add(session::Searched{5});
  journal.searching(7);
  journal.searching(9);
  write_file(file_, read_file(file_) + "{\"do\":\"undo\",\"crc\":\"0");  // torn
  const ReadJournal read = read_journal(file_);
  ASSERT_EQ(read.commands.size(), 2u);
  EXPECT_EQ(std::get<session::Searched>(read.commands[0]).points, 5);
  EXPECT_EQ(std::get<session::Searched>(read.commands[1]).points, 9);
}

TEST_F(Journal, WhatIsNoneIsRefused) {
  write_file(file_, "hello\n");
  EXPECT_THROW((void)read_journal(file_), InputError);
  write_file(file_, event_line({{"do", "undo"}}) + "\n");
  EXPECT_THROW((void)read_journal(file_), InputError);
}

}  // namespace
}  // namespace legwright
