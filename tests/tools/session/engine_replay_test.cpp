// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>
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

  static std::vector<double> end_of(const std::vector<SessionCommand>& commands,
                                    bool solves = true) {
    SessionEngine engine(test::puppy(), test::sideways(), test::kSideways);
    if (!solves) engine.set_stop([] { return true; });
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

TEST_F(Replay, DoesNotSolveForWhatIsThere) { EXPECT_EQ(end_of(commands_, false), end_); }

TEST_F(Replay, SolvesAnewWhereFIsAnotherOrTheSizesDoNotFit) {
  const std::vector<std::function<void(Found&)>> spoils{
      [](Found& found) { found.values[0] *= 1.001; },  // as of a program whose F is another
      [](Found& found) { found.motions[0].conservativeResize(7); },
      [](Found& found) { found.motions.clear(); },
      [](Found& found) { found.s[0] += 1e-6; },  // of another body
      [](Found& found) { found.motions[0][3] = std::numeric_limits<double>::quiet_NaN(); },
      [](Found& found) { found.motions[0][3] = 1e160; }};
  const std::vector<SessionCommand> whole{commands_.front()};
  const std::vector<double> solved = end_of(whole, false);
  for (std::size_t k = 0; k < spoils.size(); ++k) {
    commands_ = whole;
    spoils[k](first());
    EXPECT_EQ(end_of(commands_), solved) << k;
    EXPECT_NE(end_of(commands_, false), solved) << k << " was taken over";
  }
}

TEST_F(Replay, FitsWhatIsWithinTheBoundsAndNotFrozen) {
  const SessionEngine engine(test::puppy(), test::sideways(), test::kSideways);
  Found found = first();
  EXPECT_TRUE(fits(found, *engine.state()));
  found.s[0] = 9.0;
  EXPECT_FALSE(fits(found, *engine.state()));
  SessionState frozen = *engine.state();
  frozen.frozen[1] = true;
  found = first();
  EXPECT_TRUE(fits(found, frozen));
  found.s[1] *= 1.001;
  EXPECT_FALSE(fits(found, frozen));
  EXPECT_TRUE(fits(found, *engine.state()));
}

/// What a replay had to solve for stands in its own journal.
TEST_F(Replay, LeavesAJournalThatNeedsNoSolve) {
  for (SessionCommand& command : commands_) command = without_found(command);
  const test::TemporaryFolder folder;
  Session::Options options;
  options.journal = folder.path() / "session.jsonl";
  options.commands = commands_;
  Session(test::puppy(), test::sideways(), test::kSideways, options).close();
  EXPECT_EQ(end_of(read_journal(options.journal).commands, false), end_);
}

}  // namespace
}  // namespace legwright
