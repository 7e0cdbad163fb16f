// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/session/puppy.hpp"
#include "tools/session/session.hpp"

namespace legwright {
namespace {

using namespace std::chrono_literals;
using test::bits;
using test::kThigh;

/// A session with solves, a search and a step, and its journal.
class Replay : public testing::Test {
 protected:
  std::vector<SessionCommand> commands_;
  std::vector<double> end_;

  void SetUp() override {
    const test::TemporaryFolder folder;
    Session::Options options;
    options.journal = folder.path() / "session.jsonl";
    Session session(test::puppy(), test::sideways(), test::kSideways, options);
    ASSERT_TRUE(session.wait(60s));
    session.apply(session::Edit{{{kThigh, 0.061}}});
    ASSERT_TRUE(session.wait(60s));
    session.start();
    while (session.snapshot()->state->iterations < 5) std::this_thread::sleep_for(1ms);
    session.pause();
    (void)session.step();
    ASSERT_TRUE(session.wait(60s));
    end_ = bits(*session.snapshot()->state);
    session.close();
    commands_ = read_journal(options.journal).commands;
  }

  static std::vector<double> end_of(const std::vector<SessionCommand>& commands) {
    SessionEngine engine(test::puppy(), test::sideways(), test::kSideways);
    for (const SessionCommand& command : commands) engine.apply(command);
    return bits(*engine.state());
  }
  /// What the first solve found.
  Found& first() { return *std::get<session::Settled>(commands_.front()).found; }
};

TEST_F(Replay, TakesWhatWasFoundToTheBitAndSolvesToTheSameWithoutIt) {
  for (const SessionCommand& command : commands_)
    if (!std::holds_alternative<session::Edit>(command)) {
      EXPECT_TRUE(json_of(command).contains("found")) << json_of(command);
    }
  EXPECT_EQ(end_of(commands_), end_);
  std::vector<SessionCommand> asked;
  for (const SessionCommand& command : commands_) asked.push_back(without_found(command));
  EXPECT_EQ(end_of(asked), end_);
}

TEST_F(Replay, DoesNotSolveForWhatIsThere) {
  SessionEngine engine(test::puppy(), test::sideways(), test::kSideways);
  engine.set_stop([] { return true; });  // no solve gets anywhere
  for (const SessionCommand& command : commands_) engine.apply(command);
  EXPECT_EQ(bits(*engine.state()), end_);
}

TEST_F(Replay, SolvesAnewWhereFIsAnotherOrTheSizesDoNotFit) {
  const std::vector<SessionCommand> whole = commands_;
  first().values[0] *= 1.001;  // as of a program whose F is another
  EXPECT_EQ(end_of(commands_), end_);
  commands_ = whole;
  first().motions[0].conservativeResize(7);
  EXPECT_EQ(end_of(commands_), end_);
  commands_ = whole;
  first().motions.clear();
  EXPECT_EQ(end_of(commands_), end_);
  commands_ = whole;
  first().s[0] += 1e-6;  // of another body
  EXPECT_EQ(end_of(commands_), end_);
  commands_ = whole;
  first().motions[0][3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(end_of(commands_), end_);
}

TEST_F(Replay, ABodyOutsideOfTheBoundsIsNotTaken) {
  for (SessionCommand& command : commands_)
    if (auto* searched = std::get_if<session::Searched>(&command)) searched->found->s[0] = 9.0;
  EXPECT_EQ(end_of(commands_), end_);
}

}  // namespace
}  // namespace legwright
