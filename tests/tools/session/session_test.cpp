// SPDX-License-Identifier: Apache-2.0
#include "tools/session/session.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>

#include "mjcf/text/input_error.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/session/puppy.hpp"

namespace legwright {
namespace {

using namespace std::chrono_literals;
using test::bits;
using test::kThigh;
using Kind = SessionEvent::Kind;

constexpr const char* kShank = "front_shank_length";

/// While one lives, no file of this process grows beyond a size, as on a full disk.
class SmallFiles {
 public:
  explicit SmallFiles(std::uintmax_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, action_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  rlimit before_{};
  sighandler_t action_ = ::signal(SIGXFSZ, SIG_IGN);
};

class SessionTest : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  const std::filesystem::path journal_ = folder_.path() / "session.jsonl";

  std::unique_ptr<Session> open(std::vector<SessionCommand> commands = {}) const {
    Session::Options options;
    options.journal = commands.empty() ? journal_ : folder_.path() / "again.jsonl";
    options.commands = std::move(commands);
    return std::make_unique<Session>(test::puppy(), test::sideways(), test::kSideways, options);
  }
  /// Waits until a search has come to so many points.
  static void wait_for_points(const Session& session, int points) {
    while (session.snapshot()->state->iterations < points) std::this_thread::sleep_for(1ms);
  }
};

TEST_F(SessionTest, SolvesByItselfAndIsIdleThen) {
  const auto session = open();
  ASSERT_TRUE(session->wait(60s));
  const SnapshotPointer snapshot = session->snapshot();
  EXPECT_TRUE(snapshot->state->settled());
  EXPECT_EQ(snapshot->phase, SessionPhase::idle);
  EXPECT_EQ(session->events(0, 0ms).back().kind, Kind::solved);
}

TEST_F(SessionTest, ItsPhaseTellsWhatIsPendingOnceTheCallHasReturned) {
  const auto session = open();
  EXPECT_EQ(session->snapshot()->phase, SessionPhase::solving);  // for the first time
  for (int round = 0; round < 20; ++round) {
    ASSERT_TRUE(session->wait(60s));
    EXPECT_EQ(session->snapshot()->phase, SessionPhase::idle);
    session->start();
    EXPECT_EQ(session->snapshot()->phase, SessionPhase::searching);
    session->post(session::Edit{{{kThigh, 0.06 + 0.0001 * round}}});  // pauses it
    EXPECT_EQ(session->snapshot()->phase, SessionPhase::solving);
  }
}

TEST_F(SessionTest, EditingWhilePausedAndGoingOnIsThePapersWayOfWorking) {
  const auto session = open();
  session->start();
  wait_for_points(*session, 12);
  session->pause();
  const int paused_at = session->snapshot()->state->iterations;
  EXPECT_GE(paused_at, 12);
  session->apply(session::Edit{{{kThigh, 0.061}}});
  session->apply(session::Freeze{{kThigh}, true});
  const double before = session->snapshot()->state->value();
  session->start();
  ASSERT_TRUE(session->wait(60s));
  const SnapshotPointer end = session->snapshot();
  EXPECT_GT(end->state->iterations, paused_at);
  EXPECT_LT(end->state->value(), before);
  EXPECT_EQ(end->state->s()[end->state->problem->robot.space.find(kThigh)], 0.061);
  EXPECT_TRUE(end->state->settled());
}

TEST_F(SessionTest, ItsJournalLeadsToTheSameBits) {
  auto session = open();
  session->start();
  wait_for_points(*session, 5);
  session->apply(session::Edit{{{kThigh, 0.061}}});  // pauses; nothing is solved at this point
  session->apply(session::Edit{{{kShank, 0.08}}});
  (void)session->wait(60s);
  session->post(session::Edit{{{kShank, 0.081}}});
  session->post(session::Edit{{{kShank, 0.082}, {kThigh, 0.062}}});
  session->start();
  wait_for_points(*session, 20);
  session->apply(session::Undo{});
  session->apply(session::Snapshot{"here"});
  (void)session->step();
  ASSERT_TRUE(session->wait(60s));
  const std::vector<double> found = bits(*session->snapshot()->state);
  write_file(folder_.path() / "saved.jsonl", session->record().journal);
  session.reset();
  const ReadJournal read = read_journal(journal_);
  // What is saved is the same, without what a search told on its way.
  const ReadJournal saved = read_journal(folder_.path() / "saved.jsonl");
  ASSERT_EQ(saved.commands.size(), read.commands.size());
  for (std::size_t k = 0; k < read.commands.size(); ++k)
    EXPECT_EQ(json_of(saved.commands[k]), json_of(read.commands[k]));
  const auto again = open(read.commands);
  EXPECT_EQ(bits(*again->snapshot()->state), found);
  EXPECT_EQ(again->snapshot()->names, std::vector<std::string>{"here"});
}

TEST_F(SessionTest, WhatAHandHoldsIsSolvedOnceTheHandRests) {
  const auto session = open();
  ASSERT_TRUE(session->wait(60s));
  for (int k = 1; k <= 5; ++k)
    session->apply(session::Edit{{{kThigh, 0.06 + 0.001 * k}}, k > 1}, true);
  EXPECT_FALSE(session->wait(0ms)) << "motions are still to be solved";
  ASSERT_TRUE(session->wait(60s));
  const StatePointer state = session->snapshot()->state;
  EXPECT_TRUE(state->settled());
  EXPECT_EQ(state->s()[state->problem->robot.space.find(kThigh)], 0.065);
  session->apply(session::Undo{});
  const StatePointer before = session->snapshot()->state;
  EXPECT_EQ(before->s()[before->problem->robot.space.find(kThigh)], 0.06);
}

TEST_F(SessionTest, ACommandInterruptsWithinANewtonStep) {
  const auto session = open();
  session->start();
  wait_for_points(*session, 3);
  const auto start = std::chrono::steady_clock::now();
  session->pause();
  EXPECT_LT(std::chrono::steady_clock::now() - start, 20s);  // `benchmarks/session` measures it
  EXPECT_NE(session->snapshot()->phase, SessionPhase::searching);
}

TEST_F(SessionTest, ACommandRightBehindStartPausesASearchThatHasNotBegun) {
  const auto session = open();
  ASSERT_TRUE(session->wait(60s));
  for (int k = 0; k < 20; ++k) {
    const double value = 0.06 + 0.0001 * (k + 1);
    session->start();
    session->apply(session::Edit{{{kThigh, value}}});
    ASSERT_TRUE(session->wait(60s));
    const SessionState& state = *session->snapshot()->state;
    ASSERT_EQ(state.s()[state.problem->robot.space.find(kThigh)], value);
  }
}

TEST_F(SessionTest, RefusalsReachTheCallerOrTheEvents) {
  const auto session = open();
  EXPECT_THROW(session->apply(session::Edit{{{kThigh, 9.0}}}), InputError);
  EXPECT_THROW(session->apply(session::Undo{}), InputError);
  session->post(session::Edit{{{kThigh, 9.0}}});
  session->pause();
  const std::vector<SessionEvent> events = session->events(0, 0ms);
  const bool told = std::any_of(events.begin(), events.end(), [](const SessionEvent& event) {
    return event.kind == Kind::failed && event.words.find("its bounds") != std::string::npos;
  });
  EXPECT_TRUE(told);
  EXPECT_TRUE(read_journal(journal_).commands.empty() ||
              std::holds_alternative<session::Settled>(read_journal(journal_).commands[0]));
}

TEST_F(SessionTest, AJournalThatDoesNotFitIsRefusedAndTheSessionEnds) {
  EXPECT_THROW((void)open({session::Edit{{{"tail_length", 0.1}}}}), InputError);
}

TEST_F(SessionTest, CallsComeFromManyThreads) {
  const auto session = open();
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&session, k] {
      for (int i = 0; i < 10; ++i) {
        if (k == 0) session->start();
        if (k == 1) session->post(session::Edit{{{kThigh, 0.06 + 0.0001 * i}}});
        if (k == 2) session->apply(session::Edit{{{kShank, 0.08 + 0.0001 * i}}});
        if (k == 3) (void)session->snapshot()->state->value();
        (void)session->events(0, 1ms);
      }
    });
  for (std::thread& thread : threads) thread.join();
  session->pause();
  std::uint64_t last = 0;
  for (const SessionEvent& event : session->events(0, 0ms)) {
    EXPECT_EQ(event.number, last + 1);
    last = event.number;
  }
}

TEST_F(SessionTest, WhatIsAskedBeforeASearchBeganPausesItToo) {
  const auto session = open();
  session->post(session::Searched{30});  // at which the worker is while the others come
  session->start();
  session->post(session::Edit{{{kThigh, 0.061}}});
  ASSERT_TRUE(session->wait(60s));
  EXPECT_EQ(session->snapshot()->state->iterations, 30);
  const std::vector<SessionEvent> events = session->events(0, 0ms);
  EXPECT_EQ(std::count_if(events.begin(), events.end(),
                          [](const SessionEvent& event) {
                            return event.kind == Kind::ended && event.words == "paused";
                          }),
            1);
  session->post(session::Step{});
  session->start();
  session->pause();
  const int paused_at = session->snapshot()->state->iterations;
  ASSERT_TRUE(session->wait(60s));
  EXPECT_EQ(session->snapshot()->state->iterations, paused_at);
}

TEST_F(SessionTest, AnEditThatTakesTheLastOnesPlaceIsNoPartOfTheOneBefore) {
  const auto session = open();
  session->apply(session::Edit{{{kThigh, 0.061}}});
  session->post(session::Settled{});  // at which the worker is while the others come
  session->post(session::Edit{{{kThigh, 0.062}}});
  session->post(session::Edit{{{kThigh, 0.063}}, true});
  session->pause();
  const int thigh = session->snapshot()->state->problem->robot.space.find(kThigh);
  EXPECT_EQ(session->snapshot()->state->s()[thigh], 0.063);
  session->apply(session::Undo{});
  EXPECT_EQ(session->snapshot()->state->s()[thigh], 0.061);
}

TEST_F(SessionTest, AFullDiskEndsTheJournalsFileAndNotTheSession) {
  const auto session = open();
  ASSERT_TRUE(session->wait(60s));
  const std::size_t whole = read_journal(journal_).commands.size();
  {
    const SmallFiles full(std::filesystem::file_size(journal_) + 20);
    session->apply(session::Edit{{{kThigh, 0.061}}});
    session->start();
    ASSERT_TRUE(session->wait(60s));
  }
  session->apply(session::Edit{{{kThigh, 0.062}}});  // there is room again: no gap in the file
  const std::vector<SessionEvent> events = session->events(0, 0ms);
  EXPECT_EQ(std::count_if(events.begin(), events.end(),
                          [](const SessionEvent& event) {
                            return event.kind == Kind::failed &&
                                   event.words.find("goes on without") != std::string::npos;
                          }),
            1);
  EXPECT_EQ(read_journal(journal_).commands.size(), whole);
  const auto kept = folder_.path() / "kept.jsonl";
  const std::vector<double> here = bits(*session->snapshot()->state);
  write_file(kept, session->record().journal);
  session->close();
  std::vector<SessionCommand> commands = read_journal(kept).commands;
  while (!std::holds_alternative<session::Edit>(commands.back())) commands.pop_back();
  EXPECT_EQ(bits(*open(commands)->snapshot()->state), here);
}

TEST_F(SessionTest, CallsOfAClosedSessionAreRefused) {
  const auto session = open();
  session->post(session::Searched{20});
  auto waiting = std::async(std::launch::async, [&] { session->apply(session::Reset{}); });
  std::this_thread::sleep_for(10ms);
  session->close();
  session->close();
  EXPECT_THROW(waiting.get(), SessionClosed);
  EXPECT_THROW(session->apply(session::Reset{}), SessionClosed);
  EXPECT_THROW(session->start(), SessionClosed);
  EXPECT_THROW((void)session->record(), SessionClosed);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_FALSE(session->wait(60s));  // motions are left unsolved for good
  EXPECT_LT(std::chrono::steady_clock::now() - start, 30s);
  EXPECT_GT(session->snapshot()->revision, 0u);
}

TEST_F(SessionTest, EndsWhileASearchGoesOnWithItsPointsInTheJournal) {
  auto session = open();
  session->start();
  wait_for_points(*session, 1);
  session.reset();
  const std::vector<SessionCommand> commands = read_journal(journal_).commands;
  ASSERT_FALSE(commands.empty());
  const auto* const searched = std::get_if<session::Searched>(&commands.back());
  ASSERT_TRUE(searched);
  const int points = searched->points;
  EXPECT_GE(points, 1);
  EXPECT_EQ(open(commands)->snapshot()->state->iterations, points);
}

}  // namespace
}  // namespace legwright
