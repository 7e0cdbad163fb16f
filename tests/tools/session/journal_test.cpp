// SPDX-License-Identifier: Apache-2.0
#include "tools/session/journal.hpp"

#include <gtest/gtest.h>

#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/session/puppy.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"
#include "tools/run/robot_folder.hpp"

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
  EXPECT_EQ(json_of(read.commands[0]), json_of(session::Edit{{{"front_thigh_length", 0.1}}}));
  EXPECT_EQ(journal.text(), read_file(file_));
}

/// A session of a robot whose files lie elsewhere goes on with the copy that a run has of it.
TEST_F(Journal, ARobotIsKnownByWhatACopyOfItHas) {
  const RobotModel robot = read_robot(test::write_package_puppy(folder_.path() / "pkg"));
  const std::filesystem::path copy = folder_.path() / "copy";
  std::filesystem::create_directory(copy);
  write_robot_files(copy, robot.files);
  const auto sum = [&](const RobotModel& of) { return begin_of(of, "", "").robot_sha256; };
  EXPECT_EQ(sum(read_robot(copy / "robot.xml")), sum(robot));
  EXPECT_NE(sum(test::puppy()), sum(robot));
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

TEST_F(Journal, HasNoMoreOfWhatWasFoundThanIsReadAgain) {
  const Found found{
      Eigen::VectorXd::Ones(3), {Eigen::VectorXd::Ones(50)}, {1.0}, {SolveStatus::converged}};
  const std::size_t one = json_of(found).dump().size();
  SessionJournal journal(begin_, file_, 2 * one - 1);
  journal.add(session::Settled{found});
  journal.searching(7);
  journal.add(session::Searched{9, found});
  journal.add(session::Settled{Found{}});  // small; but a gap is before it
  const ReadJournal read = read_journal(file_);
  ASSERT_EQ(read.commands.size(), 3u);
  EXPECT_TRUE(std::get<session::Settled>(read.commands[0]).found);
  EXPECT_FALSE(std::get<session::Searched>(read.commands[1]).found);
  EXPECT_FALSE(std::get<session::Settled>(read.commands[2]).found);
}

TEST_F(Journal, WhatIsNoneIsRefused) {
  write_file(file_, "hello\n");
  EXPECT_THROW((void)read_journal(file_), InputError);
  write_file(file_, event_line({{"do", "undo"}}) + "\n");
  EXPECT_THROW((void)read_journal(file_), InputError);
  const std::string begin = SessionJournal(begin_, {}).text();
  for (const Json& line : {Json{{"do", 5}}, Json{{"do", nullptr}}, Json{{"points", 3}},
                           Json{{"do", "searching"}, {"points", "three"}}}) {
    write_file(file_, begin + event_line(line) + "\n");
    EXPECT_THROW((void)read_journal(file_), InputError) << line;
  }
}

TEST_F(Journal, ADamagedLineWithOthersBehindItIsToldNotPassedOver) {
  SessionJournal journal(begin_, file_);
  for (int k = 0; k < 4; ++k) journal.add(session::Reset{});
  std::string text = read_file(file_);
  const std::size_t second = text.find("reset", text.find("reset") + 1);
  text[second] = 'R';
  write_file(file_, text);
  try {
    (void)read_journal(file_);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.line(), 3);
    EXPECT_NE(std::string(error.what()).find("2 lines follow"), std::string::npos) << error.what();
  }
  write_file(file_, text.substr(0, text.find('\n', second) + 1));  // the last one
  EXPECT_EQ(read_journal(file_).commands.size(), 1u);
}

TEST_F(Journal, ReplacesAJournalAndNothingElse) {
  { const SessionJournal first(begin_, file_); }
  { const SessionJournal second(begin_, file_); }
  write_file(file_, "<mujoco/>\n");
  EXPECT_THROW(SessionJournal(begin_, file_), IoError);
  EXPECT_EQ(read_file(file_), "<mujoco/>\n");
  const std::filesystem::path link = folder_.path() / "link.jsonl";
  std::filesystem::create_symlink("session.jsonl", link);
  EXPECT_THROW(SessionJournal(begin_, link), IoError);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_THROW(SessionJournal(begin_, folder_.path()), IoError);
}

}  // namespace
}  // namespace legwright
